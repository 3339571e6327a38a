# gnuplot sdof-light-damping-phase.gp makes sdof-light-damping-phase.svg and sdof-light-damping-phase.pdf of sdof-light-damping-phase.dat
data = 'sdof-light-damping-phase.dat'
svg = "svg size 491,491 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 13.0cm,13.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-light-damping-phase.'.format
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key noenhanced Left reverse samplen 3
set xlabel 'x [m]'
set ylabel 'velocity [m/s]'
set key outside bottom center horizontal
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
plot data index 0 using 2:3 with lines lc rgb '#bbbbbb' lw 5 title 'certified orbit', \
  data index 1 using 2:3 with lines lc rgb '#0072B2' dt 1 lw 1.6 title 'aft-hbm[harmonics=5]', \
  data index 2 using 2:3 with lines lc rgb '#E69F00' dt '..-' lw 1.6 title 'event-driven[flow=cvode,tolerance=1e-4]', \
  data index 3 using 2:3 with lines lc rgb '#56B4E9' dt 1 lw 1.6 title 'event-driven[flow=modal,tolerance=1e-4]', \
  data index 4 using 2:3 with lines lc rgb '#000000' dt '-' lw 1.6 title 'exact-orbit[samples=64]', \
  data index 5 using 2:3 with lines lc rgb '#0072B2' dt '.' lw 1.6 title 'fourier-lipschitz[harmonics=5]', \
  data index 6 using 2:3 with lines lc rgb '#E69F00' dt '-' lw 1.6 title 'hat-lcp[samples=512]', \
  data index 7 using 2:3 with lines lc rgb '#000000' dt '_.' lw 1.6 title 'penalty-hbm[harmonics=5]'
unset output
}
