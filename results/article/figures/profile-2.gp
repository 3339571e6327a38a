# gnuplot profile-2.gp makes profile-2.svg and profile-2.pdf of profile-2.dat
data = 'profile-2.dat'
svg = "svg size 680,337 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 18.0cm,8.9cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'profile-2.'.format
set multiplot layout 1,3 margins 0.11,0.99,0.327,0.877 spacing 0.03,0.000
set logscale x
set xrange [1.000000e+00:8.528156e+02]
set yrange [-0.02:1.02]
set ytics 0,0.25,1
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set format x '10^{%T}'
set xlabel 'time / fastest'
set ylabel 'share of scenes solved'
unset key
set title 'error 10^{-2}'
plot data index 0 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 0 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 1 with steps lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 7 ps 0.6 notitle, \
  data index 2 with steps lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 2 with points lc rgb '#D55E00' pt 9 ps 0.6 notitle, \
  data index 3 with steps lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 11 ps 0.6 notitle, \
  data index 4 with steps lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 4 with points lc rgb '#009E73' pt 13 ps 0.6 notitle
set format y ''
unset ylabel
set title 'error 10^{-3}'
plot data index 5 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 6 with steps lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 6 with points lc rgb '#0072B2' pt 7 ps 0.6 notitle, \
  data index 7 with steps lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#D55E00' pt 9 ps 0.6 notitle, \
  data index 8 with steps lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 8 with points lc rgb '#009E73' pt 11 ps 0.6 notitle, \
  data index 9 with steps lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#009E73' pt 13 ps 0.6 notitle
set format y ''
unset ylabel
set title 'error 10^{-6}'
plot data index 10 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 10 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 11 with steps lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 7 ps 0.6 notitle, \
  data index 12 with steps lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 12 with points lc rgb '#D55E00' pt 9 ps 0.6 notitle, \
  data index 13 with steps lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 13 with points lc rgb '#009E73' pt 11 ps 0.6 notitle, \
  data index 14 with steps lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 14 with points lc rgb '#009E73' pt 13 ps 0.6 notitle
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
set tmargin at screen 0.16
set xrange [0:1]
set yrange [0:1]  # what must be plotted beside a key lies outside
set key center center horizontal maxcols 2 Left reverse samplen 2 width -4 font ',8' noenhanced
plot 2 notitle, \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'closed-hbm', \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt 7 title 'event-driven[flow=cvode]', \
  keyentry with linespoints lc rgb '#D55E00' dt '_.' lw 1.6 pt 9 title 'event-driven[flow=modal]', \
  keyentry with linespoints lc rgb '#009E73' dt '..-' lw 1.6 pt 11 title 'exact-orbit', \
  keyentry with linespoints lc rgb '#009E73' dt '-' lw 1.6 pt 13 title 'hat-lcp'
unset multiplot
unset output
}
