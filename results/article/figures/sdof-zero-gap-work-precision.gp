# gnuplot sdof-zero-gap-work-precision.gp makes sdof-zero-gap-work-precision.svg and sdof-zero-gap-work-precision.pdf of sdof-zero-gap-work-precision.dat
data = 'sdof-zero-gap-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-zero-gap-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.48e-05:3.08e-01]
set yrange [2.17e-11:2.17e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0477 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.235740e-04,6.523509e-11 to graph 1.05,0.0477 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1097 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 8.959900e-05,6.523509e-11 to graph 1.05,0.1097 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1717 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.554137e-02,4.851671e-10 to graph 1.05,0.1717 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6865 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.390790e-04,1.592999e-04 to graph 1.05,0.6865 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.7485 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.167910e-04,1.595785e-04 to graph 1.05,0.7485 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8105 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.148850e-04,1.595785e-04 to graph 1.05,0.8105 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.8725 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.026887e-01,1.595785e-04 to graph 1.05,0.8725 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.9345 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.366680e-03,4.711483e-03 to graph 1.05,0.9345 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 6.523509e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.454090e-04,2.507923e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.531700e-04,9.538823e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.671890e-04,3.498412e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.998920e-04,1.259904e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.631520e-04,4.495284e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.167910e-04,1.595785e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '5' at 3.231220e-04,2.507923e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 4.733289e-03,9.538823e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 5.909373e-03,3.498412e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 9.482555e-03,1.259904e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.425536e-02,4.495284e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.026887e-01,1.595785e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 3.810612e-03,3.059372e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 5.448809e-03,4.601287e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 8.674495e-03,1.705080e-08 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.554137e-02,4.851671e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 2.085310e-04,1.466526e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 2.184020e-04,6.523509e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 4.450800e-05,6.523509e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 8.959900e-05,6.523509e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 1.134620e-04,7.238946e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 4.935790e-04,1.876767e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 2.366680e-03,4.711483e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
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
  6.523509e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
