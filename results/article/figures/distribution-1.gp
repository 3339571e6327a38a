# gnuplot distribution-1.gp makes distribution-1.svg and distribution-1.pdf of distribution-1.dat
data = 'distribution-1.dat'
svg = "svg size 680,453 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 18.0cm,12.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'distribution-1.'.format
set multiplot layout 1,1 margins 0.11,0.99,0.499,0.908 spacing 0.03,0.000
set logscale x
set xrange [2.556200e-05:6.003044e+00]
set yrange [-0.02:1.02]
set ytics 0,0.25,1
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set format x '10^{%T}'
set xlabel 'time [s]'
set ylabel 'share of targets reached'
unset key
set title 'all targets'
plot data index 0 with steps lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 0 with points lc rgb '#0072B2' pt 5 ps 0.6 notitle, \
  data index 1 with steps lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#D55E00' pt 7 ps 0.6 notitle, \
  data index 2 with steps lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 2 with points lc rgb '#009E73' pt 9 ps 0.6 notitle, \
  data index 3 with steps lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#CC79A7' pt 11 ps 0.6 notitle, \
  data index 4 with steps lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 4 with points lc rgb '#E69F00' pt 13 ps 0.6 notitle, \
  data index 5 with steps lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 5 with points lc rgb '#56B4E9' pt 15 ps 0.6 notitle, \
  data index 6 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 6 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 7 with steps lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#0072B2' pt 7 ps 0.6 notitle, \
  data index 8 with steps lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 8 with points lc rgb '#D55E00' pt 9 ps 0.6 notitle, \
  data index 9 with steps lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#009E73' pt 11 ps 0.6 notitle, \
  data index 10 with steps lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 10 with points lc rgb '#CC79A7' pt 13 ps 0.6 notitle, \
  data index 11 with steps lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 11 with points lc rgb '#E69F00' pt 15 ps 0.6 notitle, \
  data index 12 with steps lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 12 with points lc rgb '#56B4E9' pt 5 ps 0.6 notitle, \
  data index 13 with steps lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#000000' pt 7 ps 0.6 notitle, \
  data index 14 with steps lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 14 with points lc rgb '#0072B2' pt 9 ps 0.6 notitle, \
  data index 15 with steps lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 15 with points lc rgb '#D55E00' pt 11 ps 0.6 notitle, \
  data index 16 with steps lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 16 with points lc rgb '#009E73' pt 13 ps 0.6 notitle, \
  data index 17 with steps lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 17 with points lc rgb '#E69F00' pt 5 ps 0.6 notitle, \
  data index 18 with steps lc rgb '#56B4E9' dt '..-' lw 1.6 notitle, \
  data index 18 with points lc rgb '#56B4E9' pt 7 ps 0.6 notitle, \
  data index 19 with steps lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 19 with points lc rgb '#000000' pt 9 ps 0.6 notitle, \
  data index 20 with steps lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 20 with points lc rgb '#0072B2' pt 11 ps 0.6 notitle, \
  data index 21 with steps lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 21 with points lc rgb '#D55E00' pt 13 ps 0.6 notitle, \
  data index 22 with steps lc rgb '#009E73' dt '_.' lw 1.6 notitle, \
  data index 22 with points lc rgb '#009E73' pt 15 ps 0.6 notitle
set format y ''
unset ylabel
unset logscale
unset border
unset tics
unset grid
unset xlabel
unset ylabel
unset title
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.00
set tmargin at screen 0.37
set xrange [0:1]
set yrange [0:1]  # what must be plotted beside a key lies outside
set key center center horizontal maxcols 2 Left reverse samplen 2 width -4 font ',8' noenhanced
plot 2 notitle, \
  keyentry with linespoints lc rgb '#0072B2' dt 1 lw 1.6 pt 5 title 'aft-hbm', \
  keyentry with linespoints lc rgb '#D55E00' dt '-' lw 1.6 pt 7 title 'aft-hbm[plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#009E73' dt '.' lw 1.6 pt 9 title 'aft-hbm[plain=true,homotopy=true,c=1e5]', \
  keyentry with linespoints lc rgb '#CC79A7' dt '_.' lw 1.6 pt 11 title 'aft-hbm[plain=true]', \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt 13 title 'augmented-lagrangian', \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt 15 title 'augmented-lagrangian[plain=true]', \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'closed-hbm', \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt 7 title 'event-driven[flow=cvode]', \
  keyentry with linespoints lc rgb '#D55E00' dt '_.' lw 1.6 pt 9 title 'event-driven[flow=modal]', \
  keyentry with linespoints lc rgb '#009E73' dt '..-' lw 1.6 pt 11 title 'exact-orbit', \
  keyentry with linespoints lc rgb '#CC79A7' dt 1 lw 1.6 pt 13 title 'fourier-lipschitz', \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt 15 title 'fourier-lipschitz[plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#56B4E9' dt '.' lw 1.6 pt 5 title 'fourier-lipschitz[plain=true,solver=pivoting,c=1]', \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt 7 title 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]', \
  keyentry with linespoints lc rgb '#0072B2' dt '..-' lw 1.6 pt 9 title 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]', \
  keyentry with linespoints lc rgb '#D55E00' dt 1 lw 1.6 pt 11 title 'fourier-lipschitz[plain=true]', \
  keyentry with linespoints lc rgb '#009E73' dt '-' lw 1.6 pt 13 title 'hat-lcp', \
  keyentry with linespoints lc rgb '#E69F00' dt '_.' lw 1.6 pt 5 title 'penalty-hbm', \
  keyentry with linespoints lc rgb '#56B4E9' dt '..-' lw 1.6 pt 7 title 'penalty-hbm[plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#000000' dt 1 lw 1.6 pt 9 title 'penalty-hbm[plain=true,solver=pivoting,penalty=100x]', \
  keyentry with linespoints lc rgb '#0072B2' dt '-' lw 1.6 pt 11 title 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]', \
  keyentry with linespoints lc rgb '#D55E00' dt '.' lw 1.6 pt 13 title 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]', \
  keyentry with linespoints lc rgb '#009E73' dt '_.' lw 1.6 pt 15 title 'penalty-hbm[plain=true]'
unset multiplot
unset output
}
