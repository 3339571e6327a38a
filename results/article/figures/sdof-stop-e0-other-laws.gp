# gnuplot sdof-stop-e0-other-laws.gp makes sdof-stop-e0-other-laws.svg and sdof-stop-e0-other-laws.pdf of sdof-stop-e0-other-laws.dat
data = 'sdof-stop-e0-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e0-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x, own law [-]'
set xrange [9.59e-05:3.63e-02]
set yrange [9.44e-12:1.77e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian (e = 1)' at graph 1.06,0.6757 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.621112e-03,8.265643e-05 to graph 1.05,0.6757 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian[plain=true] (e = 1)' at graph 1.06,0.9536 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.208853e-02,5.908970e-02 to graph 1.05,0.9536 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.832512e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 2.876420e-04,1.295183e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 4.698920e-04,4.927725e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.200535e-03,1.807859e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.955341e-03,6.512404e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.927321e-03,2.324693e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.621112e-03,8.265643e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.208853e-02,5.908970e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
plot data index 0 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 3 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  2.832512e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
