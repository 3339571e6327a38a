# gnuplot profile-3.gp makes profile-3.svg and profile-3.pdf of profile-3.dat
data = 'profile-3.dat'
svg = "svg size 680,340 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 18.0cm,9.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'profile-3.'.format
set multiplot layout 1,3 margins 0.06,0.99,0.36,0.90 spacing 0.03,0
set logscale x
set xrange [1:2.754447e+03]
set yrange [-0.02:1.02]
set ytics 0,0.25,1
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set format x '10^{%T}'
set xlabel 'time / fastest'
unset key
set title 'error 1e-02'
plot data index 0 with steps lc rgb '#E69F00' dt '..-' lw 1.6 notitle, data index 0 with points lc rgb '#E69F00' pt 13 ps 0.6 notitle, \
  data index 1 with steps lc rgb '#56B4E9' dt 1 lw 1.6 notitle, data index 1 with points lc rgb '#56B4E9' pt 15 ps 0.6 notitle, \
  data index 2 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, data index 2 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 3 with steps lc rgb '#E69F00' dt '-' lw 1.6 notitle, data index 3 with points lc rgb '#E69F00' pt 15 ps 0.6 notitle
set format y ''
set title 'error 1e-03'
plot data index 4 with steps lc rgb '#E69F00' dt '..-' lw 1.6 notitle, data index 4 with points lc rgb '#E69F00' pt 13 ps 0.6 notitle, \
  data index 5 with steps lc rgb '#56B4E9' dt 1 lw 1.6 notitle, data index 5 with points lc rgb '#56B4E9' pt 15 ps 0.6 notitle, \
  data index 6 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, data index 6 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 7 with steps lc rgb '#E69F00' dt '-' lw 1.6 notitle, data index 7 with points lc rgb '#E69F00' pt 15 ps 0.6 notitle
set format y ''
set title 'error 1e-06'
plot data index 8 with steps lc rgb '#E69F00' dt '..-' lw 1.6 notitle, data index 8 with points lc rgb '#E69F00' pt 13 ps 0.6 notitle, \
  data index 9 with steps lc rgb '#56B4E9' dt 1 lw 1.6 notitle, data index 9 with points lc rgb '#56B4E9' pt 15 ps 0.6 notitle, \
  data index 10 with steps lc rgb '#000000' dt '-' lw 1.6 notitle, data index 10 with points lc rgb '#000000' pt 5 ps 0.6 notitle, \
  data index 11 with steps lc rgb '#E69F00' dt '-' lw 1.6 notitle, data index 11 with points lc rgb '#E69F00' pt 15 ps 0.6 notitle
set format y ''
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
set tmargin at screen 0.20
set xrange [0:1]
set yrange [0:1]  # what must be plotted beside a key lies outside
set key center center horizontal maxcols 4 Left reverse samplen 3 font ',9' noenhanced
plot 2 notitle, \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt 13 title 'event-driven[flow=cvode]', \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt 15 title 'event-driven[flow=modal]', \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt 5 title 'exact-orbit', \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt 15 title 'hat-lcp'
unset multiplot
unset output
}
