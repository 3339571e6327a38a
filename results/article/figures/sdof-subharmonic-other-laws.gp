# gnuplot sdof-subharmonic-other-laws.gp makes sdof-subharmonic-other-laws.svg and sdof-subharmonic-other-laws.pdf of sdof-subharmonic-other-laws.dat
data = 'sdof-subharmonic-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-subharmonic-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force, own law [-]'
set xrange [2.82e-04:8.56e-02]
set yrange [3.53e-10:1.36e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian[plain=true] (e = 1)' at graph 1.06,0.8065 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 2.852257e-02,2.967634e-03 to graph 1.05,0.8065 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.060029e-09 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '10' at 8.471030e-04,4.532437e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40' at 8.588722e-03,1.176001e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160' at 2.852257e-02,2.967634e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
plot data index 0 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  1.060029e-09 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
