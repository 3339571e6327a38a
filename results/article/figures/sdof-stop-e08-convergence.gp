# gnuplot sdof-stop-e08-convergence.gp makes sdof-stop-e08-convergence.svg and sdof-stop-e08-convergence.pdf of sdof-stop-e08-convergence.dat
data = 'sdof-stop-e08-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e08-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x and force [-]'
set xrange [1.67e+00:2.46e+04]
set yrange [2.72e-05:1.06e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.835
set label 'closed-hbm' at graph 1.06,0.1328 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.600000e+02,8.147548e-05 to graph 1.05,0.1328 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.5444 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.192000e+03,2.450348e-03 to graph 1.05,0.5444 nohead lc rgb '#009E73' lw 0.5 back
set object polygon from 2.0000e+00,1.0863e-04 to 4.0000e+00,5.4317e-05 to 2.0000e+00,5.4317e-05 to 2.0000e+00,1.0863e-04 fillstyle empty border lc rgb '#666666'
set label '1' at 4.0000e+00,7.6816e-05 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 2.0000e+00,1.7381e-03 to 4.0000e+00,4.3454e-04 to 2.0000e+00,4.3454e-04 to 2.0000e+00,1.7381e-03 fillstyle empty border lc rgb '#666666'
set label '2' at 4.0000e+00,8.6907e-04 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '5' at 5.000000e+00,1.274851e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.000000e+01,4.850412e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.000000e+01,1.779537e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 4.000000e+01,6.410838e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 8.000000e+01,2.289053e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 1.600000e+02,8.147548e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 5.120000e+02,3.537496e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.048000e+03,9.822029e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 8.192000e+03,2.450348e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 13 ps 1.1 notitle
unset output
}
