# gnuplot chain2-penalty-work-precision.gp makes chain2-penalty-work-precision.svg and chain2-penalty-work-precision.pdf of chain2-penalty-work-precision.dat
data = 'chain2-penalty-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain2-penalty-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.47e-05:8.28e-01]
set yrange [1.29e-12:1.76e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0428 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.985660e-04,3.867267e-12 to graph 1.05,0.0428 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1048 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.872380e-04,3.867267e-12 to graph 1.05,0.1048 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1895 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.285125e-02,1.662349e-10 to graph 1.05,0.1895 nohead lc rgb '#000000' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.3800 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.039608e-01,4.324082e-07 to graph 1.05,0.3800 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.4420 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.232575e-03,4.324083e-07 to graph 1.05,0.4420 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.350857e-03,4.333244e-07 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.254382e-03,4.333244e-07 to graph 1.05,0.5660 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.6280 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.989060e-02,7.617098e-06 to graph 1.05,0.6280 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.129185e-02,5.747343e-05 to graph 1.05,0.6900 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.751242e-03,8.673447e-04 to graph 1.05,0.7520 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.352765e-01,1.612063e-03 to graph 1.05,0.8140 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.097586e-02,1.612063e-03 to graph 1.05,0.8760 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 2.056240e-02,1.612063e-03 to graph 1.05,0.9380 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.760771e-01,1.612063e-03 to graph 1.05,1.0000 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.867267e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 7.248700e-05,5.866778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.115080e-04,1.604151e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 3.288260e-04,2.261525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 6.824340e-04,4.717726e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.637180e-04,4.028597e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.350857e-03,4.333244e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.352765e-01,1.612063e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 2.097586e-02,1.612063e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 1.806200e-04,3.239699e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 3.270500e-04,9.695253e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.065283e-03,1.550204e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.438297e-03,4.288010e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.751577e-02,3.938685e-06 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.039608e-01,4.324082e-07 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 9.220975e-03,1.895179e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 1.502339e-02,4.683487e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 2.271923e-02,4.463436e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 3.285125e-02,1.662349e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 3.784030e-04,7.242879e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 3.881100e-04,3.867267e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 1.116290e-04,3.867267e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10' at 7.470500e-05,1.604151e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 2.412800e-04,2.261525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 2.760771e-01,1.612063e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '128' at 1.269750e-04,2.177756e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 1.756282e-03,8.673447e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 6.815806e-03,3.374001e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 2.989060e-02,7.617098e-06 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '5' at 4.424400e-05,3.239699e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10' at 7.736600e-05,9.695253e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '20' at 2.333030e-04,1.550204e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 1.129185e-02,5.747343e-05 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 12 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 14 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 16 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 17 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 18 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 19 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 20 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 22 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 24 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 26 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  data index 27 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 28 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  3.867267e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
