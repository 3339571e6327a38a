# gnuplot chain2-penalty-waveforms.gp makes chain2-penalty-waveforms.svg and chain2-penalty-waveforms.pdf of chain2-penalty-waveforms.dat
data = 'chain2-penalty-waveforms.dat'
svg = "svg size 643,782 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,20.7cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain2-penalty-waveforms.'.format
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set multiplot layout 4,1 margins 0.11,0.98,0.329,0.98 spacing 0,0.03
set xrange [0:9.6664]
set format x ''
unset key
set arrow 1 from graph 0, first 0.999991 to graph 1, first 0.999991 nohead lc rgb '#D55E00' dt (12,6) lw 1.2
set label 1 'stop' at graph 1, first 0.999991 right offset 0,-0.6 font ',8' textcolor rgb '#D55E00'
set ylabel 'x [m]'
plot data index 0 using 1:2 with lines lc rgb '#bbbbbb' lw 5, \
  data index 2 using 1:2 with lines lc rgb '#0072B2' dt 1 lw 1.6, \
  data index 4 using 1:2 with lines lc rgb '#D55E00' dt '-' lw 1.6, \
  data index 6 using 1:2 with lines lc rgb '#009E73' dt '.' lw 1.6, \
  data index 8 using 1:2 with lines lc rgb '#E69F00' dt '..-' lw 1.6, \
  data index 10 using 1:2 with lines lc rgb '#000000' dt '-' lw 1.6, \
  data index 12 using 1:2 with lines lc rgb '#0072B2' dt '.' lw 1.6, \
  data index 14 using 1:2 with lines lc rgb '#D55E00' dt '_.' lw 1.6, \
  data index 16 using 1:2 with lines lc rgb '#009E73' dt '..-' lw 1.6, \
  data index 18 using 1:2 with lines lc rgb '#CC79A7' dt 1 lw 1.6, \
  data index 20 using 1:2 with lines lc rgb '#E69F00' dt '-' lw 1.6, \
  data index 22 using 1:2 with lines lc rgb '#000000' dt '_.' lw 1.6, \
  data index 24 using 1:2 with lines lc rgb '#0072B2' dt '..-' lw 1.6, \
  data index 26 using 1:2 with lines lc rgb '#D55E00' dt 1 lw 1.6, \
  data index 28 using 1:2 with lines lc rgb '#CC79A7' dt '.' lw 1.6
unset arrow
unset label
set ylabel 'velocity [m/s]'
plot data index 0 using 1:3 with lines lc rgb '#bbbbbb' lw 5, \
  data index 2 using 1:3 with lines lc rgb '#0072B2' dt 1 lw 1.6, \
  data index 4 using 1:3 with lines lc rgb '#D55E00' dt '-' lw 1.6, \
  data index 6 using 1:3 with lines lc rgb '#009E73' dt '.' lw 1.6, \
  data index 8 using 1:3 with lines lc rgb '#E69F00' dt '..-' lw 1.6, \
  data index 10 using 1:3 with lines lc rgb '#000000' dt '-' lw 1.6, \
  data index 12 using 1:3 with lines lc rgb '#0072B2' dt '.' lw 1.6, \
  data index 14 using 1:3 with lines lc rgb '#D55E00' dt '_.' lw 1.6, \
  data index 16 using 1:3 with lines lc rgb '#009E73' dt '..-' lw 1.6, \
  data index 18 using 1:3 with lines lc rgb '#CC79A7' dt 1 lw 1.6, \
  data index 20 using 1:3 with lines lc rgb '#E69F00' dt '-' lw 1.6, \
  data index 22 using 1:3 with lines lc rgb '#000000' dt '_.' lw 1.6, \
  data index 24 using 1:3 with lines lc rgb '#0072B2' dt '..-' lw 1.6, \
  data index 26 using 1:3 with lines lc rgb '#D55E00' dt 1 lw 1.6, \
  data index 28 using 1:3 with lines lc rgb '#CC79A7' dt '.' lw 1.6
set ylabel 'force of the stop [N]'
plot data index 0 using 1:4 with lines lc rgb '#bbbbbb' lw 5, \
  data index 2 using 1:4 with lines lc rgb '#0072B2' dt 1 lw 1.6, \
  data index 4 using 1:4 with lines lc rgb '#D55E00' dt '-' lw 1.6, \
  data index 6 using 1:4 with lines lc rgb '#009E73' dt '.' lw 1.6, \
  data index 8 using 1:4 with lines lc rgb '#E69F00' dt '..-' lw 1.6, \
  data index 10 using 1:4 with lines lc rgb '#000000' dt '-' lw 1.6, \
  data index 12 using 1:4 with lines lc rgb '#0072B2' dt '.' lw 1.6, \
  data index 14 using 1:4 with lines lc rgb '#D55E00' dt '_.' lw 1.6, \
  data index 16 using 1:4 with lines lc rgb '#009E73' dt '..-' lw 1.6, \
  data index 18 using 1:4 with lines lc rgb '#CC79A7' dt 1 lw 1.6, \
  data index 20 using 1:4 with lines lc rgb '#E69F00' dt '-' lw 1.6, \
  data index 22 using 1:4 with lines lc rgb '#000000' dt '_.' lw 1.6, \
  data index 24 using 1:4 with lines lc rgb '#0072B2' dt '..-' lw 1.6, \
  data index 26 using 1:4 with lines lc rgb '#D55E00' dt 1 lw 1.6, \
  data index 28 using 1:4 with lines lc rgb '#CC79A7' dt '.' lw 1.6
set format x '%g'
set xlabel 't [s]'
set ylabel 'impulse so far [N s]'
plot data index 0 using 1:5 with lines lc rgb '#bbbbbb' lw 5, \
  data index 2 using 1:5 with lines lc rgb '#0072B2' dt 1 lw 1.6, \
  data index 4 using 1:5 with lines lc rgb '#D55E00' dt '-' lw 1.6, \
  data index 6 using 1:5 with lines lc rgb '#009E73' dt '.' lw 1.6, \
  data index 8 using 1:5 with lines lc rgb '#E69F00' dt '..-' lw 1.6, \
  data index 10 using 1:5 with lines lc rgb '#000000' dt '-' lw 1.6, \
  data index 12 using 1:5 with lines lc rgb '#0072B2' dt '.' lw 1.6, \
  data index 14 using 1:5 with lines lc rgb '#D55E00' dt '_.' lw 1.6, \
  data index 16 using 1:5 with lines lc rgb '#009E73' dt '..-' lw 1.6, \
  data index 18 using 1:5 with lines lc rgb '#CC79A7' dt 1 lw 1.6, \
  data index 20 using 1:5 with lines lc rgb '#E69F00' dt '-' lw 1.6, \
  data index 22 using 1:5 with lines lc rgb '#000000' dt '_.' lw 1.6, \
  data index 24 using 1:5 with lines lc rgb '#0072B2' dt '..-' lw 1.6, \
  data index 26 using 1:5 with lines lc rgb '#D55E00' dt 1 lw 1.6, \
  data index 28 using 1:5 with lines lc rgb '#CC79A7' dt '.' lw 1.6
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
set tmargin at screen 0.27
set xrange [0:1]
set yrange [0:1]  # what must be plotted beside a key lies outside
set key center center horizontal maxcols 1 Left reverse samplen 2 width -4 font ',8' noenhanced
plot 2 notitle, \
  keyentry with linespoints lc rgb '#bbbbbb' lw 5 pt -1 title 'certified orbit', \
  keyentry with linespoints lc rgb '#0072B2' dt 1 lw 1.6 pt -1 title 'aft-hbm[harmonics=5]', \
  keyentry with linespoints lc rgb '#D55E00' dt '-' lw 1.6 pt -1 title 'aft-hbm[harmonics=40,plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#009E73' dt '.' lw 1.6 pt -1 title 'aft-hbm[harmonics=40,plain=true,homotopy=true]', \
  keyentry with linespoints lc rgb '#E69F00' dt '..-' lw 1.6 pt -1 title 'augmented-lagrangian[harmonics=5]', \
  keyentry with linespoints lc rgb '#000000' dt '-' lw 1.6 pt -1 title 'event-driven[flow=cvode,tolerance=1e-4]', \
  keyentry with linespoints lc rgb '#0072B2' dt '.' lw 1.6 pt -1 title 'event-driven[flow=modal,tolerance=1e-4]', \
  keyentry with linespoints lc rgb '#D55E00' dt '_.' lw 1.6 pt -1 title 'exact-orbit[samples=64]', \
  keyentry with linespoints lc rgb '#009E73' dt '..-' lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=5]', \
  keyentry with linespoints lc rgb '#CC79A7' dt 1 lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=40,plain=true,continuation=frequency]', \
  keyentry with linespoints lc rgb '#E69F00' dt '-' lw 1.6 pt -1 title 'fourier-lipschitz[harmonics=40,plain=true,solver=pivoting]', \
  keyentry with linespoints lc rgb '#000000' dt '_.' lw 1.6 pt -1 title 'hat-lcp[samples=128]', \
  keyentry with linespoints lc rgb '#0072B2' dt '..-' lw 1.6 pt -1 title 'hat-lcp[samples=512,plain=true]', \
  keyentry with linespoints lc rgb '#D55E00' dt 1 lw 1.6 pt -1 title 'penalty-hbm[harmonics=5]', \
  keyentry with linespoints lc rgb '#CC79A7' dt '.' lw 1.6 pt -1 title 'penalty-hbm[harmonics=40,plain=true,solver=pivoting]'
unset multiplot
unset output
}
