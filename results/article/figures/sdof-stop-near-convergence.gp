# gnuplot sdof-stop-near-convergence.gp makes sdof-stop-near-convergence.svg and sdof-stop-near-convergence.pdf of sdof-stop-near-convergence.dat
data = 'sdof-stop-near-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-near-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x and force [-]'
set xrange [1.67e+00:2.46e+04]
set yrange [1.39e-04:2.83e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'closed-hbm' at graph 1.06,0.1441 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.600000e+02,4.162334e-04 to graph 1.05,0.1441 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3462 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.192000e+03,1.941525e-03 to graph 1.05,0.3462 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.5861 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.600000e+02,1.208362e-02 to graph 1.05,0.5861 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.6481 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.208362e-02 to graph 1.05,0.6481 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.7101 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.600000e+02,1.604478e-02 to graph 1.05,0.7101 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.7721 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,1.604478e-02 to graph 1.05,0.7721 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.8341 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.669519e-02 to graph 1.05,0.8341 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.8961 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.600000e+02,1.713847e-02 to graph 1.05,0.8961 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.9581 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,3.627559e-02 to graph 1.05,0.9581 nohead lc rgb '#0072B2' lw 0.5 back
set object polygon from 2.0000e+00,5.5498e-04 to 4.0000e+00,2.7749e-04 to 2.0000e+00,2.7749e-04 to 2.0000e+00,5.5498e-04 fillstyle empty border lc rgb '#666666'
set label '1' at 4.0000e+00,3.9243e-04 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 2.0000e+00,8.8796e-03 to 4.0000e+00,2.2199e-03 to 2.0000e+00,2.2199e-03 to 2.0000e+00,8.8796e-03 fillstyle empty border lc rgb '#666666'
set label '2' at 4.0000e+00,4.4398e-03 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '40' at 4.000000e+01,6.341775e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.000000e+01,3.195962e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.600000e+02,1.604478e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 2.000000e+01,9.440482e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.000000e+01,4.782827e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 8.000000e+01,2.408108e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.600000e+02,1.208362e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '5' at 5.000000e+00,6.753077e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.000000e+01,2.517532e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.000000e+01,9.166612e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 4.000000e+01,3.293174e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 8.000000e+01,1.173744e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 1.600000e+02,4.162334e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 5.120000e+02,3.095318e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.048000e+03,7.759946e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 8.192000e+03,1.941525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160' at 1.600000e+02,3.627559e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
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
  data index 14 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 17 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle
unset output
}
