# gnuplot chain10-stop-work-precision.gp makes chain10-stop-work-precision.svg and chain10-stop-work-precision.pdf of chain10-stop-work-precision.dat
data = 'chain10-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain10-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.01e-04:3.31e-01]
set yrange [3.47e-12:2.21e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.511
set label 'event-driven[flow=modal]' at graph 1.06,0.0442 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.645064e-03,1.041120e-11 to graph 1.05,0.0442 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1062 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 9.526610e-04,1.041120e-11 to graph 1.05,0.1062 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1682 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.101800e-01,1.773977e-11 to graph 1.05,0.1682 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.259408e-03,2.205477e-04 to graph 1.05,0.6280 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.6900 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.219060e-03,2.209479e-04 to graph 1.05,0.6900 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.7520 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.193619e-03,2.209479e-04 to graph 1.05,0.7520 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 3.120248e-02,2.209479e-04 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.326037e-02,1.227616e-03 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 2.454545e-02,1.773017e-02 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 3.024825e-03,4.654119e-02 to graph 1.05,1.0000 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.041120e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '10' at 1.399660e-03,1.299312e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.471007e-03,5.067281e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.620675e-03,1.742944e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.023796e-03,6.213566e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 3.219060e-03,2.209479e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 3.225331e-03,5.067281e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 7.108430e-03,1.742944e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 9.420059e-03,6.213566e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 3.120248e-02,2.209479e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 2.454545e-02,1.773017e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '1e-4' at 2.314883e-02,4.539119e-06 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 3.843928e-02,5.400001e-08 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 6.907852e-02,2.183175e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.101800e-01,1.773977e-11 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.551999e-03,1.041120e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 7.731040e-04,1.041120e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '128' at 3.027220e-04,7.379318e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 5.252080e-03,4.735112e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 2.326037e-02,1.227616e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 3.024825e-03,4.654119e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 5 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 13 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 19 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  1.041120e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
