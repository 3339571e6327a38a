# gnuplot sdof-chatter-convergence.gp makes sdof-chatter-convergence.svg and sdof-chatter-convergence.pdf of sdof-chatter-convergence.dat
data = 'sdof-chatter-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-chatter-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x and force [-]'
set xrange [1.71e+02:2.46e+04]
set yrange [3.31e-04:4.77e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.869
set label 'hat-lcp' at graph 1.06,0.2209 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.192000e+03,9.918905e-04 to graph 1.05,0.2209 nohead lc rgb '#009E73' lw 0.5 back
set object polygon from 2.0480e+02,1.3225e-03 to 4.0960e+02,6.6126e-04 to 2.0480e+02,6.6126e-04 to 2.0480e+02,1.3225e-03 fillstyle empty border lc rgb '#666666'
set label '1' at 4.0960e+02,9.3516e-04 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 2.0480e+02,2.1160e-02 to 4.0960e+02,5.2901e-03 to 2.0480e+02,5.2901e-03 to 2.0480e+02,2.1160e-02 fillstyle empty border lc rgb '#666666'
set label '2' at 4.0960e+02,1.0580e-02 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '512' at 5.120000e+02,1.591127e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.048000e+03,4.005317e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 8.192000e+03,9.918905e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#009E73' pt 13 ps 1.1 notitle
unset output
}
