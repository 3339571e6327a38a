# gnuplot sdof-stop-e08-work-precision.gp makes sdof-stop-e08-work-precision.svg and sdof-stop-e08-work-precision.pdf of sdof-stop-e08-work-precision.dat
data = 'sdof-stop-e08-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e08-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.60e-05:3.23e-02]
set yrange [1.30e-12:1.06e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = 3.914646e-12  # ten error bars of the least certain orbit
plot floor with lines lc rgb '#888888' dt 3 lw 1 title 'error bar x 10', \
  data index 0 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt 13 title 'event-driven[flow=cvode]', \
  data index 2 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 4 with points lc rgb '#56B4E9' pt 14 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt 15 title 'event-driven[flow=modal]', \
  data index 5 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 6 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'exact-orbit', \
  data index 7 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 8 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt 15 title 'hat-lcp'
unset output
}
