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
set xrange [1.52e-05:8.22e-01]
set yrange [1.29e-12:1.76e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0428 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.976070e-04,3.867267e-12 to graph 1.05,0.0428 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1048 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.891510e-04,3.867267e-12 to graph 1.05,0.1048 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1895 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.223561e-02,1.662349e-10 to graph 1.05,0.1895 nohead lc rgb '#000000' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.3800 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.048793e-01,4.324082e-07 to graph 1.05,0.3800 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.4420 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.235755e-03,4.324083e-07 to graph 1.05,0.4420 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.318311e-03,4.333244e-07 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.242729e-03,4.333244e-07 to graph 1.05,0.5660 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.6280 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.948894e-02,7.617098e-06 to graph 1.05,0.6280 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.148109e-02,5.747343e-05 to graph 1.05,0.6900 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.752344e-03,8.673447e-04 to graph 1.05,0.7520 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.313268e-01,1.612063e-03 to graph 1.05,0.8140 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.154918e-02,1.612063e-03 to graph 1.05,0.8760 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 2.033336e-02,1.612063e-03 to graph 1.05,0.9380 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.741445e-01,1.612063e-03 to graph 1.05,1.0000 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.867267e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 7.423900e-05,5.866778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.152680e-04,1.604151e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 3.330020e-04,2.261525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 6.865820e-04,4.717726e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.684150e-04,4.028597e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.318311e-03,4.333244e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.313268e-01,1.612063e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 2.154918e-02,1.612063e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 1.833670e-04,3.239699e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 3.338240e-04,9.695253e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.063041e-03,1.550204e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.407095e-03,4.288010e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.756461e-02,3.938685e-06 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.048793e-01,4.324082e-07 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 9.042581e-03,1.895179e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 1.490689e-02,4.683487e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 2.207921e-02,4.463436e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 3.223561e-02,1.662349e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 3.735730e-04,7.242879e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 3.869740e-04,3.867267e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 1.142770e-04,3.867267e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10' at 7.792100e-05,1.604151e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 2.444430e-04,2.261525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 2.741445e-01,1.612063e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '128' at 1.284110e-04,2.177756e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 1.754592e-03,8.673447e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 6.823608e-03,3.374001e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 2.948894e-02,7.617098e-06 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '5' at 4.553100e-05,3.239699e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10' at 8.045800e-05,9.695253e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '20' at 2.360220e-04,1.550204e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 1.148109e-02,5.747343e-05 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
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
