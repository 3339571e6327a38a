# gnuplot sdof-stop-other-laws.gp makes sdof-stop-other-laws.svg and sdof-stop-other-laws.pdf of sdof-stop-other-laws.dat
data = 'sdof-stop-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x, own law [-]'
set xrange [2.83e-05:2.55e-04]
set yrange [9.41e-12:5.82e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = 2.823575e-11  # ten error bars of the least certain orbit
plot floor with lines lc rgb '#888888' dt 3 lw 1 title 'error bar x 10', \
  data index 0 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 1 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt '.' lw 1.6 pt 5 title 'hat-lcp[plain=true] (undetermined)'
unset output
}
