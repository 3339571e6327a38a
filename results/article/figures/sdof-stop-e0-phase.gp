# gnuplot sdof-stop-e0-phase.gp makes sdof-stop-e0-phase.svg and sdof-stop-e0-phase.pdf of sdof-stop-e0-phase.dat
data = 'sdof-stop-e0-phase.dat'
svg = "svg size 491,491 font 'sans-serif,11' background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 13.0cm,13.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e0-phase.'.format
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key noenhanced Left reverse samplen 3
set xlabel 'x [m]'
set ylabel 'velocity [m/s]'
set key outside bottom center horizontal
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
plot data index 0 using 2:3 with lines lc rgb '#bbbbbb' lw 5 title 'certified orbit', \
  data index 1 using 2:3 with lines lc rgb '#E69F00' dt '..-' lw 1.6 title 'event-driven[flow=cvode,tolerance=1e-4]', \
  data index 2 using 2:3 with lines lc rgb '#56B4E9' dt 1 lw 1.6 title 'event-driven[flow=modal,tolerance=1e-4]', \
  data index 3 using 2:3 with lines lc rgb '#000000' dt '-' lw 1.6 title 'exact-orbit[samples=64]', \
  data index 4 using 2:3 with lines lc rgb '#E69F00' dt '-' lw 1.6 title 'hat-lcp[samples=128]'
unset output
}
