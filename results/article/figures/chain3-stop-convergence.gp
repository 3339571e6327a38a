# gnuplot chain3-stop-convergence.gp makes chain3-stop-convergence.svg and chain3-stop-convergence.pdf of chain3-stop-convergence.dat
data = 'chain3-stop-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-stop-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x [-]'
set xrange [1.67e+00:2.46e+04]
set yrange [1.28e-04:1.89e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.724
set label 'penalty-hbm' at graph 1.06,0.1505 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.600000e+02,3.828425e-04 to graph 1.05,0.1505 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.2125 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,3.835223e-04 to graph 1.05,0.2125 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.2745 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,3.835223e-04 to graph 1.05,0.2745 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.3365 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.600000e+02,3.835223e-04 to graph 1.05,0.3365 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3985 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 8.192000e+03,2.118438e-03 to graph 1.05,0.3985 nohead lc rgb '#000000' lw 0.5 back
set object polygon from 2.0000e+00,5.1046e-04 to 4.0000e+00,2.5523e-04 to 2.0000e+00,2.5523e-04 to 2.0000e+00,5.1046e-04 fillstyle empty border lc rgb '#666666'
set label '1' at 4.0000e+00,3.6095e-04 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 2.0000e+00,8.1673e-03 to 4.0000e+00,2.0418e-03 to 2.0000e+00,2.0418e-03 to 2.0000e+00,8.1673e-03 fillstyle empty border lc rgb '#666666'
set label '2' at 4.0000e+00,4.0837e-03 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '5' at 5.000000e+00,6.290424e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.000000e+01,2.321292e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 2.000000e+01,8.443515e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 4.000000e+01,3.033815e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.000000e+01,1.081523e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.600000e+02,3.835223e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 5.120000e+02,3.442923e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 2.048000e+03,8.597140e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 8.192000e+03,2.118438e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 9 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle
unset output
}
