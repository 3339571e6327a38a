# gnuplot sdof-penalty-stiff-convergence.gp makes sdof-penalty-stiff-convergence.svg and sdof-penalty-stiff-convergence.pdf of sdof-penalty-stiff-convergence.dat
data = 'sdof-penalty-stiff-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-penalty-stiff-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x and force [-]'
set xrange [3.33e+00:2.46e+04]
set yrange [3.69e-03:4.17e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'hat-lcp' at graph 1.06,0.1588 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.192000e+03,1.126952e-02 to graph 1.05,0.1588 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.2208 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.600000e+02,1.587779e-02 to graph 1.05,0.2208 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.2828 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.587779e-02 to graph 1.05,0.2828 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.3448 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.587779e-02 to graph 1.05,0.3448 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.4068 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,2.404111e-02 to graph 1.05,0.4068 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.4688 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,2.446511e-02 to graph 1.05,0.4688 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.5308 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.600000e+02,2.446511e-02 to graph 1.05,0.5308 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5928 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.600000e+02,2.446511e-02 to graph 1.05,0.5928 nohead lc rgb '#CC79A7' lw 0.5 back
set object polygon from 4.0000e+00,1.4765e-02 to 8.0000e+00,7.3824e-03 to 4.0000e+00,7.3824e-03 to 4.0000e+00,1.4765e-02 fillstyle empty border lc rgb '#666666'
set label '1' at 8.0000e+00,1.0440e-02 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 4.0000e+00,2.3624e-01 to 8.0000e+00,5.9059e-02 to 4.0000e+00,5.9059e-02 to 4.0000e+00,2.3624e-01 fillstyle empty border lc rgb '#666666'
set label '2' at 8.0000e+00,1.1812e-01 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '20' at 2.000000e+01,7.593215e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 4.000000e+01,5.364694e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.000000e+01,2.415066e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.600000e+02,2.446511e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.000000e+01,6.231317e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 2.000000e+01,4.852533e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.000000e+01,3.277021e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 8.000000e+01,1.523418e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.600000e+02,1.587779e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '512' at 5.120000e+02,1.391388e+00 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.048000e+03,1.107359e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 8.192000e+03,1.126952e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
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
  data index 15 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle
unset output
}
