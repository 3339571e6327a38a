# gnuplot bar10-massless-penalty.gp makes bar10-massless-penalty.svg and bar10-massless-penalty.pdf of bar10-massless-penalty.dat
data = 'bar10-massless-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'bar10-massless-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+01:3.00e+05]
set yrange [8.98e-05:1.37e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'penalty-hbm[harmonics=160,plain=true,solver=pivoting]' at graph 1.06,0.1587 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+05,2.874346e-04 to graph 1.05,0.1587 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm[harmonics=40,plain=true,solver=pivoting]' at graph 1.06,0.5199 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+05,4.058017e-03 to graph 1.05,0.5199 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[harmonics=10,plain=true,solver=pivoting]' at graph 1.06,0.8476 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+05,4.478302e-02 to graph 1.05,0.8476 nohead lc rgb '#0072B2' lw 0.5 back
set label '' at 1.000000e+02,4.561688e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,4.529412e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,4.478302e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+02,1.930541e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+04,3.453647e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+05,4.058017e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+02,1.369680e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+04,2.695276e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+05,2.874346e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle
unset output
}
