# gnuplot sdof-stop-convergence.gp makes sdof-stop-convergence.svg and sdof-stop-convergence.pdf of sdof-stop-convergence.dat
data = 'sdof-stop-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x and force [-]'
set xrange [1.67e+00:2.46e+04]
set yrange [2.76e-05:2.42e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'closed-hbm' at graph 1.06,0.1210 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.600000e+02,8.265643e-05 to graph 1.05,0.1210 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.4976 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.192000e+03,2.524157e-03 to graph 1.05,0.4976 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.600000e+02,1.548778e-02 to graph 1.05,0.6900 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.7520 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.548778e-02 to graph 1.05,0.7520 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8140 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.600000e+02,2.051131e-02 to graph 1.05,0.8140 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,2.051131e-02 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.9380 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,2.131526e-02 to graph 1.05,0.9380 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.600000e+02,3.637403e-02 to graph 1.05,1.0000 nohead lc rgb '#D55E00' lw 0.5 back
set object polygon from 2.0000e+00,1.1021e-04 to 4.0000e+00,5.5104e-05 to 2.0000e+00,5.5104e-05 to 2.0000e+00,1.1021e-04 fillstyle empty border lc rgb '#666666'
set label '1' at 4.0000e+00,7.7929e-05 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 2.0000e+00,1.7633e-03 to 4.0000e+00,4.4083e-04 to 2.0000e+00,4.4083e-04 to 2.0000e+00,1.7633e-03 fillstyle empty border lc rgb '#666666'
set label '2' at 4.0000e+00,8.8167e-04 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '40' at 4.000000e+01,7.758057e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.000000e+01,4.024793e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.600000e+02,2.051131e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.000000e+01,3.048273e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.600000e+02,1.548778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '5' at 5.000000e+00,1.295183e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.000000e+01,4.927725e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.000000e+01,1.807859e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 4.000000e+01,6.512404e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 8.000000e+01,2.324693e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 1.600000e+02,8.265643e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 5.120000e+02,3.856259e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.048000e+03,1.010643e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 8.192000e+03,2.524157e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160' at 1.600000e+02,3.637403e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 5 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 9 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 11 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 15 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle
unset output
}
