# gnuplot sdof-stop-e08-other-laws.gp makes sdof-stop-e08-other-laws.svg and sdof-stop-e08-other-laws.pdf of sdof-stop-e08-other-laws.dat
data = 'sdof-stop-e08-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e08-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x, own law [-]'
set xrange [2.89e-05:1.20e-01]
set yrange [9.69e-12:1.88e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = 2.907063e-11  # ten error bars of the least certain orbit
plot floor with lines lc rgb '#888888' dt 3 lw 1 title 'error bar x 10', \
  data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt 1 lw 1.6 pt 5 title 'aft-hbm (e = 1)', \
  data index 2 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt 7 title 'fourier-lipschitz (e = 1)', \
  data index 4 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt '.' lw 1.6 pt 5 title 'hat-lcp[plain=true] (undetermined)', \
  data index 6 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt 7 title 'penalty-hbm (e = 1)'
unset output
}
