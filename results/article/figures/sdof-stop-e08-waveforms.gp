# gnuplot sdof-stop-e08-waveforms.gp makes sdof-stop-e08-waveforms.svg and sdof-stop-e08-waveforms.pdf of sdof-stop-e08-waveforms.dat
data = 'sdof-stop-e08-waveforms.dat'
svg = "svg size 643,680 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,18.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e08-waveforms.'.format
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key noenhanced Left reverse samplen 3
set multiplot layout 4,1 margins 0.11,0.98,0.25,0.98 spacing 0,0.03
set xrange [0:2.856]
set format x ''
unset key
set ylabel 'x [m]'
plot data index 0 using 1:2 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 2 using 1:2 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 using 1:2 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 4 using 1:2 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle
set ylabel 'velocity [m/s]'
plot data index 0 using 1:3 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:3 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 2 using 1:3 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 using 1:3 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 4 using 1:3 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle
set ylabel 'force [N]'
plot data index 0 using 1:4 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 2 using 1:4 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 using 1:4 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 4 using 1:4 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle
set format x '%g'
set xlabel 't [s]'
set ylabel 'impulse so far [N s]'
plot data index 0 using 1:5 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:5 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 2 using 1:5 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 using 1:5 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 4 using 1:5 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle
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
set tmargin at screen 0.18
set xrange [0:1]
set yrange [0:1]  # what must be plotted beside a key lies outside
set key center center horizontal maxcols 2 Left reverse samplen 3 font ',9' noenhanced
plot 2 notitle, \
  keyentry with linespoints lc rgb '#bbbbbb' lw 5 pt -1 title 'certified orbit', \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt -1 title 'event-driven[flow=cvode,tolerance=1e-4]', \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt -1 title 'event-driven[flow=modal,tolerance=1e-4]', \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt -1 title 'exact-orbit[samples=64]', \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt -1 title 'hat-lcp[samples=512]'
unset multiplot
unset output
}
