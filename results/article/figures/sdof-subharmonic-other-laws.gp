# gnuplot sdof-subharmonic-other-laws.gp makes sdof-subharmonic-other-laws.svg and sdof-subharmonic-other-laws.pdf of sdof-subharmonic-other-laws.dat
data = 'sdof-subharmonic-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-subharmonic-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x, own law [-]'
set xrange [9.44e-05:1.15e-01]
set yrange [3.53e-10:9.71e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian (e = 1)' at graph 1.06,0.6832 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 3.849819e-02,2.059059e-04 to graph 1.05,0.6832 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian[plain=true] (e = 1)' at graph 1.06,0.8914 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 7.285658e-03,1.176001e-02 to graph 1.05,0.8914 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.060029e-09 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 2.831380e-04,3.235412e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 4.973320e-04,1.230028e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.917122e-03,4.510674e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.936107e-03,1.624469e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 6.757382e-03,5.796864e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 3.849819e-02,2.059059e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 7.285658e-03,1.176001e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
plot data index 0 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  1.060029e-09 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
