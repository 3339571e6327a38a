# gnuplot chain3-stop-work-precision.gp makes chain3-stop-work-precision.svg and chain3-stop-work-precision.pdf of chain3-stop-work-precision.dat
data = 'chain3-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [4.06e-05:1.27e-01]
set yrange [1.84e-12:1.89e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=cvode]' at graph 1.06,0.0433 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.567471e-02,5.526554e-12 to graph 1.05,0.0433 nohead lc rgb '#000000' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1053 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.894090e-04,5.526554e-12 to graph 1.05,0.1053 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1673 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.346900e-04,5.526554e-12 to graph 1.05,0.1673 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.7520 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.061046e-03,3.828425e-04 to graph 1.05,0.7520 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 4.246205e-02,3.835223e-04 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.030793e-03,3.835223e-04 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.9380 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.041321e-03,3.835223e-04 to graph 1.05,0.9380 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.348594e-02,2.118438e-03 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 5.526554e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 4.870370e-04,6.290424e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 4.927040e-04,2.321292e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 5.144370e-04,8.443515e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 5.629250e-04,3.033815e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 6.854650e-04,1.081523e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.030793e-03,3.835223e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 7.678120e-04,2.321292e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 2.461347e-03,8.443515e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.109070e-02,3.033815e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 3.492198e-02,1.081523e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 4.246205e-02,3.835223e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 5.953112e-03,3.554580e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 1.101987e-02,4.101073e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 1.899841e-02,4.216873e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 2.567471e-02,5.526554e-12 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 2.602250e-04,8.047426e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 2.743500e-04,5.526554e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 1.219440e-04,5.526554e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 6.693020e-04,3.442923e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 1.348594e-02,2.118438e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 6 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  data index 7 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 8 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 13 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  5.526554e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
