# gnuplot chain3-massless-penalty.gp makes chain3-massless-penalty.svg and chain3-massless-penalty.pdf of chain3-massless-penalty.dat
data = 'chain3-massless-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-massless-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+01:3.00e+05]
set yrange [1.51e-04:6.50e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'penalty-hbm[harmonics=160,plain=true,solver=pivoting]' at graph 1.06,0.1456 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+05,5.111858e-04 to graph 1.05,0.1456 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm[harmonics=40,plain=true,solver=pivoting]' at graph 1.06,0.4049 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+05,4.477006e-03 to graph 1.05,0.4049 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[harmonics=10,plain=true,solver=pivoting]' at graph 1.06,0.8687 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+05,2.167137e-01 to graph 1.05,0.8687 nohead lc rgb '#0072B2' lw 0.5 back
set label '' at 1.000000e+02,1.364214e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,1.737588e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,2.167137e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+02,5.406875e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+04,4.229324e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+05,4.477006e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+04,4.538062e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+05,5.111858e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 4 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle
unset output
}
