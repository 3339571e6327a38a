# gnuplot chain3-massless-work-precision.gp makes chain3-massless-work-precision.svg and chain3-massless-work-precision.pdf of chain3-massless-work-precision.dat
data = 'chain3-massless-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-massless-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [2.89e-05:2.59e+01]
set yrange [1.15e-11:2.67e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = 3.453322e-11  # ten error bars of the least certain orbit
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
  data index 6 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt 13 title 'event-driven[flow=cvode]', \
  data index 8 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 9 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 10 with points lc rgb '#56B4E9' pt 14 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt 15 title 'event-driven[flow=modal]', \
  data index 11 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 12 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'exact-orbit', \
  data index 13 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 14 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt 7 title 'fourier-lipschitz', \
  data index 15 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 16 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#D55E00' dt '_.' lw 1.6 pt 9 title 'fourier-lipschitz[plain=true,continuation=frequency]', \
  data index 17 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 18 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#009E73' dt '..-' lw 1.6 pt 11 title 'fourier-lipschitz[plain=true,solver=pivoting]', \
  data index 19 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 20 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt 15 title 'hat-lcp', \
  data index 21 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 22 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#56B4E9' dt '.' lw 1.6 pt 5 title 'hat-lcp[plain=true]', \
  data index 23 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 24 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt 7 title 'penalty-hbm', \
  data index 25 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 26 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt '..-' lw 1.6 pt 9 title 'penalty-hbm[plain=true,continuation=frequency]', \
  data index 27 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 28 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  keyentry with linespoints lc rgb '#D55E00' dt 1 lw 1.6 pt 11 title 'penalty-hbm[plain=true,solver=pivoting]'
unset output
}
