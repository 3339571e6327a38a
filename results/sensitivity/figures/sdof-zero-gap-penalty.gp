# gnuplot sdof-zero-gap-penalty.gp makes sdof-zero-gap-penalty.svg and sdof-zero-gap-penalty.pdf of sdof-zero-gap-penalty.dat
data = 'sdof-zero-gap-penalty.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-zero-gap-penalty.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'penalty, in units of its scale [-]'
set ylabel 'error of x [-]'
set xrange [3.33e+00:3.00e+06]
set yrange [4.19e-04:4.87e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian[harmonics=40]' at graph 1.06,0.1174 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.000000e+06,1.256296e-03 to graph 1.05,0.1174 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[harmonics=40]' at graph 1.06,0.1794 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.000000e+06,1.256297e-03 to graph 1.05,0.1794 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[harmonics=160,compensate=false]' at graph 1.06,0.4674 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.000000e+06,3.326856e-02 to graph 1.05,0.4674 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[harmonics=40,compensate=false]' at graph 1.06,0.5831 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.000000e+06,9.833336e-02 to graph 1.05,0.5831 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm[harmonics=10,compensate=false]' at graph 1.06,0.7088 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.000000e+06,3.189529e-01 to graph 1.05,0.7088 nohead lc rgb '#D55E00' lw 0.5 back
set label '' at 1.000000e+03,1.898851e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+04,1.344925e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+05,1.261073e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+06,1.256296e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '' at 1.000000e+01,1.623156e+00 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+02,1.062496e+00 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+03,5.706917e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+04,3.791329e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+05,3.305666e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+06,3.189529e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '' at 1.000000e+04,2.105349e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+05,1.195726e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+06,9.833336e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '' at 1.000000e+03,3.543288e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '' at 1.000000e+05,6.842974e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '' at 1.000000e+06,3.326856e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 6 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with points lc rgb '#009E73' pt 8 ps 1.1 notitle, \
  data index 7 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 8 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 10 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 11 with points lc rgb '#E69F00' pt 12 ps 1.1 notitle
unset output
}
