# gnuplot sdof-stop-resonance-penalty.gp makes sdof-stop-resonance-penalty.svg and sdof-stop-resonance-penalty.pdf of sdof-stop-resonance-penalty.dat
data = 'sdof-stop-resonance-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-resonance-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+01:3.00e+06]
set yrange [8.28e-04:8.65e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.668
set label 'penalty-hbm[harmonics=40]' at graph 1.06,0.2363 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+06,2.484885e-03 to graph 1.05,0.2363 nohead lc rgb '#0072B2' lw 0.5 back
set label '' at 1.000000e+02,2.882881e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+03,4.403411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,2.580223e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,2.489000e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+06,2.484885e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle
unset output
}
