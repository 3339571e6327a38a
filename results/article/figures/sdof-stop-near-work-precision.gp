# gnuplot sdof-stop-near-work-precision.gp makes sdof-stop-near-work-precision.svg and sdof-stop-near-work-precision.pdf of sdof-stop-near-work-precision.dat
data = 'sdof-stop-near-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-near-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.75e-05:1.21e-01]
set yrange [3.76e-13:2.02e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = 1.127771e-12  # ten error bars of the least certain orbit
plot floor with lines lc rgb '#888888' dt 3 lw 1 title 'error bar x 10', \
  data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt 1 lw 1.6 pt 5 title 'aft-hbm', \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt 13 title 'event-driven[flow=cvode]', \
  data index 4 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 5 with points lc rgb '#56B4E9' pt 14 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt 15 title 'event-driven[flow=modal]', \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'exact-orbit', \
  data index 8 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt 7 title 'fourier-lipschitz', \
  data index 10 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 11 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt 15 title 'hat-lcp', \
  data index 12 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt 7 title 'penalty-hbm'
unset output
}
