# gnuplot sdof-chatter-other-laws.gp makes sdof-chatter-other-laws.svg and sdof-chatter-other-laws.pdf of sdof-chatter-other-laws.dat
data = 'sdof-chatter-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-chatter-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x, own law [-]'
set xrange [2.39e-03:4.15e-01]
set yrange [1.30e-12:1.07e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.634
set label 'augmented-lagrangian (e = 1)' at graph 1.06,0.8321 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.383377e-01,1.578510e-03 to graph 1.05,0.8321 nohead lc rgb '#E69F00' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.900630e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '20' at 7.159494e-03,3.581846e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 8.808010e-03,1.192237e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.928801e-02,4.354223e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.383377e-01,1.578510e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
plot data index 0 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  3.900630e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
