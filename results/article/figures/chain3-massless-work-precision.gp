# gnuplot chain3-massless-work-precision.gp makes chain3-massless-work-precision.svg and chain3-massless-work-precision.pdf of chain3-massless-work-precision.dat
data = 'chain3-massless-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-massless-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [3.11e-05:1.42e+00]
set yrange [1.15e-11:2.76e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'exact-orbit' at graph 1.06,0.0460 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 8.569900e-04,3.453322e-11 to graph 1.05,0.0460 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1080 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.474770e-04,3.453322e-11 to graph 1.05,0.1080 nohead lc rgb '#0072B2' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1700 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.207522e-02,1.765778e-10 to graph 1.05,0.1700 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 4.198925e-02,1.266682e-05 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.3800 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.757575e-03,2.522940e-04 to graph 1.05,0.3800 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.4420 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.602016e-03,2.522940e-04 to graph 1.05,0.4420 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.5040 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.821905e-02,3.273856e-04 to graph 1.05,0.5040 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.944405e-03,4.874716e-04 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 5.408826e-03,1.290375e-03 to graph 1.05,0.6280 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.912447e-02,2.049411e-03 to graph 1.05,0.6900 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.263284e-02,2.049411e-03 to graph 1.05,0.7520 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 3.131388e-02,2.049411e-03 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 6.117608e-02,2.049411e-03 to graph 1.05,0.8760 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.401241e-02,5.406875e-03 to graph 1.05,0.9380 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[plain=true,continuation=frequency]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.720310e-01,5.406875e-03 to graph 1.05,1.0000 nohead lc rgb '#009E73' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.453322e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '10' at 1.629020e-04,8.892529e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 4.676210e-04,7.758753e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 9.272980e-04,2.315190e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 1.407741e-03,7.702444e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 2.757575e-03,2.522940e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.912447e-02,2.049411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 3.263284e-02,2.049411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 3.624400e-04,9.202605e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.701599e-03,1.584734e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 7.084884e-03,2.731554e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.692909e-02,9.007636e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.821905e-02,3.273856e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 7.072770e-03,1.041987e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 1.106481e-02,6.169463e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 1.608294e-02,2.958697e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 2.207522e-02,1.765778e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 2.348220e-04,4.009282e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 2.457410e-04,3.453322e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 1.557740e-04,3.453322e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 8.569900e-04,3.453322e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10' at 1.101020e-04,8.892529e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 3.009640e-04,7.758753e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 6.117608e-02,2.049411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '128' at 2.007320e-04,8.961175e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 3.922536e-03,4.874716e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 4.106786e-03,1.049774e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 4.198925e-02,1.266682e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.782070e-04,1.072303e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 9.241110e-04,8.388665e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '80' at 1.678157e-03,3.426578e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 5.408826e-03,1.290375e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 4.720310e-01,5.406875e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 2.401241e-02,5.406875e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
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
  data index 27 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 28 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 29 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 30 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  3.453322e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
