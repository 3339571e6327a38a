# gnuplot bar20-massless-penalty.gp makes bar20-massless-penalty.svg and bar20-massless-penalty.pdf of bar20-massless-penalty.dat
data = 'bar20-massless-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'bar20-massless-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+00:3.00e+06]
set yrange [6.83e-05:6.37e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'penalty-hbm[harmonics=160,compensate=false]' at graph 1.06,0.1839 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.000000e+06,2.402520e-04 to graph 1.05,0.1839 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[harmonics=40,compensate=false]' at graph 1.06,0.4611 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.000000e+06,1.599295e-03 to graph 1.05,0.4611 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[harmonics=40]' at graph 1.06,0.5231 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.000000e+06,1.599295e-03 to graph 1.05,0.5231 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian[harmonics=40,plain=true]' at graph 1.06,0.5851 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+06,1.599300e-03 to graph 1.05,0.5851 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian[harmonics=40]' at graph 1.06,0.6471 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+06,1.599300e-03 to graph 1.05,0.6471 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[harmonics=10,compensate=false]' at graph 1.06,0.8393 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+06,2.122415e-02 to graph 1.05,0.8393 nohead lc rgb '#009E73' lw 0.5 back
set label '' at 1.000000e+01,1.123163e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+02,1.334155e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+03,1.503080e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,1.579227e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,1.595713e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+06,1.599300e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+01,1.472969e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+02,1.948900e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+03,2.084307e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+04,2.114465e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+05,2.121004e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+06,2.122415e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+01,4.259528e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '' at 1.000000e+02,4.592643e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+03,2.050089e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+04,2.274017e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+05,2.377525e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '' at 1.000000e+06,2.402520e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
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
