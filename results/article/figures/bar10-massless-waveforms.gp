# gnuplot bar10-massless-waveforms.gp makes bar10-massless-waveforms.svg and bar10-massless-waveforms.pdf of bar10-massless-waveforms.dat
data = 'bar10-massless-waveforms.dat'
svg = "svg size 643,680 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,18.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'bar10-massless-waveforms.'.format
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key noenhanced Left reverse samplen 3
set multiplot layout 4,1 margins 0.11,0.98,0.25,0.98 spacing 0,0.03
set xrange [0:5.236]
set format x ''
unset key
set ylabel 'x [m]'
plot data index 0 using 1:2 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:2 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 2 using 1:2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 using 1:2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 4 using 1:2 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 5 using 1:2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 6 using 1:2 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 using 1:2 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 8 using 1:2 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 using 1:2 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 10 using 1:2 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 11 using 1:2 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 12 using 1:2 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 13 using 1:2 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 14 using 1:2 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 using 1:2 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 16 using 1:2 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 using 1:2 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle
set ylabel 'velocity [m/s]'
plot data index 0 using 1:3 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:3 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 2 using 1:3 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 using 1:3 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 4 using 1:3 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 5 using 1:3 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 6 using 1:3 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 using 1:3 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 8 using 1:3 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 using 1:3 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 10 using 1:3 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 11 using 1:3 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 12 using 1:3 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 13 using 1:3 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 14 using 1:3 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 using 1:3 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 16 using 1:3 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 using 1:3 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle
set ylabel 'force [N]'
plot data index 0 using 1:4 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:4 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 2 using 1:4 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 using 1:4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 4 using 1:4 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 5 using 1:4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 6 using 1:4 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 using 1:4 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 8 using 1:4 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 using 1:4 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 10 using 1:4 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 11 using 1:4 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 12 using 1:4 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 13 using 1:4 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 14 using 1:4 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 using 1:4 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 16 using 1:4 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 using 1:4 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle
set format x '%g'
set xlabel 't [s]'
set ylabel 'impulse so far [N s]'
plot data index 0 using 1:5 with lines lc rgb '#bbbbbb' lw 5 notitle, \
  data index 1 using 1:5 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 2 using 1:5 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 using 1:5 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 4 using 1:5 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 5 using 1:5 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 6 using 1:5 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 using 1:5 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 8 using 1:5 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 using 1:5 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 10 using 1:5 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 11 using 1:5 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 12 using 1:5 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 13 using 1:5 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 14 using 1:5 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 using 1:5 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 16 using 1:5 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 using 1:5 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle
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
  keyentry with linespoints lc rgb '#0072B2' dt 1 lw 1.6 pt -1 title 'aft-hbm[harmonics=5]', \
  keyentry with linespoints lc rgb '#D55E00' dt '-' lw 1.6 pt -1 title 'aft-hbm[harmonics=40,plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#009E73' dt '.' lw 1.6 pt -1 title 'aft-hbm[harmonics=40,plain=true,homotopy=true]', \
  keyentry with linespoints lc rgb '#CC79A7' dt '_.' lw 1.6 pt -1 title 'aft-hbm[harmonics=40,plain=true]', \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt -1 title 'event-driven[flow=cvode,tolerance=1e-4]', \
  keyentry with linespoints lc rgb '#56B4E9' dt 1 lw 1.6 pt -1 title 'event-driven[flow=modal,tolerance=1e-4]', \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt -1 title 'exact-orbit[samples=64]', \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=5]', \
  keyentry with linespoints lc rgb '#D55E00' dt '_.' lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=40,plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#009E73' dt '..-' lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=40,plain=true,solver=pivoting]', \
  keyentry with linespoints lc rgb '#CC79A7' dt 1 lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=40,plain=true]', \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt -1 title 'hat-lcp[samples=128]', \
  keyentry with linespoints lc rgb '#56B4E9' dt '.' lw 1.6 pt -1 title 'hat-lcp[samples=512,plain=true]', \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt -1 title 'penalty-hbm[harmonics=5]', \
  keyentry with linespoints lc rgb '#0072B2' dt '..-' lw 1.6 pt -1 title 'penalty-hbm[harmonics=40,plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#D55E00' dt 1 lw 1.6 pt -1 title 'penalty-hbm[harmonics=40,plain=true,solver=pivoting]', \
  keyentry with linespoints lc rgb '#009E73' dt '-' lw 1.6 pt -1 title 'penalty-hbm[harmonics=40,plain=true]'
unset multiplot
unset output
}
