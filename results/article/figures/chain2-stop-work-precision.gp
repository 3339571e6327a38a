# gnuplot chain2-stop-work-precision.gp makes chain2-stop-work-precision.svg and chain2-stop-work-precision.pdf of chain2-stop-work-precision.dat
data = 'chain2-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain2-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [3.13e-05:1.41e-01]
set yrange [1.50e-12:2.03e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0429 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.611830e-04,4.489287e-12 to graph 1.05,0.0429 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1049 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.946830e-04,4.489287e-12 to graph 1.05,0.1049 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1669 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.363410e-02,6.122950e-11 to graph 1.05,0.1669 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.7520 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 8.865820e-04,4.217374e-04 to graph 1.05,0.7520 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 4.686723e-02,4.224794e-04 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 8.901000e-04,4.224794e-04 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.9380 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.787580e-04,4.224794e-04 to graph 1.05,0.9380 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.296037e-02,3.704387e-03 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 4.489287e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 4.197960e-04,6.761893e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 4.245470e-04,2.540333e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 4.479560e-04,9.283311e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 4.887560e-04,3.339746e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 5.892440e-04,1.191050e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 8.901000e-04,4.224794e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '5' at 5.617530e-04,6.761893e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 9.530050e-04,2.540333e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.446061e-02,9.283311e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.634371e-02,3.339746e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.507267e-02,1.191050e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 4.686723e-02,4.224794e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 3.699969e-03,1.417666e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 6.414546e-03,2.264217e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 1.158197e-02,4.039629e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.363410e-02,6.122950e-11 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.546780e-04,1.712643e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.611020e-04,4.489287e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 9.400700e-05,4.489287e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 2.946830e-04,4.489287e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '2048' at 2.359868e-03,1.485072e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 1.296037e-02,3.704387e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 8 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 10 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 11 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 12 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 14 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 16 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  4.489287e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
