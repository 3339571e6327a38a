# gnuplot sdof-stop-other-laws.gp makes sdof-stop-other-laws.svg and sdof-stop-other-laws.pdf of sdof-stop-other-laws.dat
data = 'sdof-stop-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x, own law [-]'
set xrange [2.45e-05:2.20e-04]
set yrange [9.41e-12:5.82e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.567
set label 'hat-lcp[plain=true] (undetermined)' at graph 1.06,0.9513 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 7.345600e-05,1.938685e-02 to graph 1.05,0.9513 nohead lc rgb '#0072B2' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.823575e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '512' at 7.345600e-05,1.938685e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  2.823575e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
