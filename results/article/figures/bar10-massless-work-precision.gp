# gnuplot bar10-massless-work-precision.gp makes bar10-massless-work-precision.svg and bar10-massless-work-precision.pdf of bar10-massless-work-precision.dat
data = 'bar10-massless-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'bar10-massless-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.63e-05:1.12e+01]
set yrange [3.10e-12:1.91e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = 9.286077e-12  # ten error bars of the least certain orbit
plot floor with lines lc rgb '#888888' dt 3 lw 1 title 'error bar x 10', \
  data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt 1 lw 1.6 pt 5 title 'aft-hbm', \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#D55E00' dt '-' lw 1.6 pt 7 title 'aft-hbm[plain=true,continuation=frequency]', \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#009E73' dt '.' lw 1.6 pt 9 title 'aft-hbm[plain=true,homotopy=true]', \
  data index 6 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#CC79A7' dt '_.' lw 1.6 pt 11 title 'aft-hbm[plain=true]', \
  data index 8 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 10 with points lc rgb '#E69F00' pt 12 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt 13 title 'event-driven[flow=cvode]', \
  data index 11 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 12 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 13 with points lc rgb '#56B4E9' pt 14 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt 15 title 'event-driven[flow=modal]', \
  data index 14 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'exact-orbit', \
  data index 16 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 17 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt 7 title 'fourier-lipschitz', \
  data index 18 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 19 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#D55E00' dt '_.' lw 1.6 pt 9 title 'fourier-lipschitz[plain=true,continuation=frequency]', \
  data index 20 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 21 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#009E73' dt '..-' lw 1.6 pt 11 title 'fourier-lipschitz[plain=true,solver=pivoting]', \
  data index 22 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 23 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#CC79A7' dt 1 lw 1.6 pt 13 title 'fourier-lipschitz[plain=true]', \
  data index 24 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 25 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt 15 title 'hat-lcp', \
  data index 26 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 27 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt '.' lw 1.6 pt 5 title 'hat-lcp[plain=true]', \
  data index 28 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 29 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt 7 title 'penalty-hbm', \
  data index 30 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 31 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt '..-' lw 1.6 pt 9 title 'penalty-hbm[plain=true,continuation=frequency]', \
  data index 32 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 33 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#D55E00' dt 1 lw 1.6 pt 11 title 'penalty-hbm[plain=true,solver=pivoting]', \
  data index 34 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 35 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#009E73' dt '-' lw 1.6 pt 13 title 'penalty-hbm[plain=true]'
unset output
}
