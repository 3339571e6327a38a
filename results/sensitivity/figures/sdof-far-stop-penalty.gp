# gnuplot sdof-far-stop-penalty.gp makes sdof-far-stop-penalty.svg and sdof-far-stop-penalty.pdf of sdof-far-stop-penalty.dat
data = 'sdof-far-stop-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-far-stop-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+00:3.00e+06]
set yrange [5.39e-13:4.85e-12]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian[harmonics=40]' at graph 1.06,0.5000 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+06,1.616444e-12 to graph 1.05,0.5000 nohead lc rgb '#0072B2' lw 0.5 back
set label 'augmented-lagrangian[harmonics=40,plain=true]' at graph 1.06,0.5620 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+06,1.616444e-12 to graph 1.05,0.5620 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[harmonics=10,compensate=false]' at graph 1.06,0.6240 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+06,1.616444e-12 to graph 1.05,0.6240 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm[harmonics=40,compensate=false]' at graph 1.06,0.6860 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.000000e+06,1.616444e-12 to graph 1.05,0.6860 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[harmonics=40]' at graph 1.06,0.7480 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.000000e+06,1.616444e-12 to graph 1.05,0.7480 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[harmonics=160,compensate=false]' at graph 1.06,0.8100 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.000000e+06,1.616444e-12 to graph 1.05,0.8100 nohead lc rgb '#56B4E9' lw 0.5 back
set label '' at 1.000000e+01,1.616444e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+02,1.616444e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+03,1.616444e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,1.616444e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,1.616444e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+06,1.616444e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 11 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle
unset output
}
