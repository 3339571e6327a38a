# gnuplot sdof-stop-other-laws.gp makes sdof-stop-other-laws.svg and sdof-stop-other-laws.pdf of sdof-stop-other-laws.dat
data = 'sdof-stop-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force, own law [-]'
set xrange [2.68e-05:2.41e-04]
set yrange [9.41e-12:1.25e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.567
set label 'hat-lcp[plain=true] (undetermined)' at graph 1.06,0.9529 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 8.037300e-05,4.178261e-02 to graph 1.05,0.9529 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.823575e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '512' at 8.037300e-05,4.178261e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
plot data index 0 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 1 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  2.823575e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
