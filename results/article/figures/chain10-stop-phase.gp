# gnuplot chain10-stop-phase.gp makes chain10-stop-phase.svg and chain10-stop-phase.pdf of chain10-stop-phase.dat
data = 'chain10-stop-phase.dat'
svg = "svg size 454,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 12.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain10-stop-phase.'.format
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set xlabel 'x [m]'
set ylabel 'velocity [m/s]'
unset key
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set xtics 0.5
set arrow 1 from 0.39999, graph 0 to 0.39999, graph 1 nohead lc rgb '#D55E00' dt (12,6) lw 1.2
plot data index 1 with lines lc rgb '#bbbbbb' lw 5, \
  data index 3 with lines lc rgb '#0072B2' dt 1 lw 1.6, \
  data index 5 with lines lc rgb '#E69F00' dt '..-' lw 1.6, \
  data index 7 with lines lc rgb '#56B4E9' dt 1 lw 1.6, \
  data index 9 with lines lc rgb '#000000' dt '-' lw 1.6, \
  data index 11 with lines lc rgb '#0072B2' dt '.' lw 1.6, \
  data index 13 with lines lc rgb '#D55E00' dt '_.' lw 1.6, \
  data index 15 with lines lc rgb '#009E73' dt '..-' lw 1.6, \
  data index 17 with lines lc rgb '#000000' dt '_.' lw 1.6, \
  data index 19 with lines lc rgb '#D55E00' dt 1 lw 1.6, \
  data index 21 with lines lc rgb '#CC79A7' dt '.' lw 1.6
unset output
}
