# gnuplot sdof-subharmonic-work-precision.gp makes sdof-subharmonic-work-precision.svg and sdof-subharmonic-work-precision.pdf of sdof-subharmonic-work-precision.dat
data = 'sdof-subharmonic-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-subharmonic-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.57e-05:4.24e-02]
set yrange [1.62e-11:1.73e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'exact-orbit' at graph 1.06,0.0476 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 9.112500e-05,4.872673e-11 to graph 1.05,0.0476 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1096 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.697510e-04,7.350445e-11 to graph 1.05,0.1096 nohead lc rgb '#0072B2' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1716 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.413809e-02,7.712447e-10 to graph 1.05,0.1716 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.7081 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.501770e-04,2.049539e-04 to graph 1.05,0.7081 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.7701 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.278650e-04,2.053161e-04 to graph 1.05,0.7701 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8321 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.269430e-04,2.053161e-04 to graph 1.05,0.8321 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8941 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.493248e-03,1.470621e-02 to graph 1.05,0.8941 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 7.350445e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.485700e-04,3.223647e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.574790e-04,1.225565e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.724550e-04,4.494370e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 2.071400e-04,1.618658e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.684940e-04,5.776960e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.278650e-04,2.053161e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 3.820779e-03,8.839281e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 5.805357e-03,8.871724e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 8.847594e-03,3.663797e-08 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.413809e-02,7.712447e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.589410e-04,4.133363e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.697510e-04,7.350445e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 4.697000e-05,7.350445e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 9.112500e-05,4.872673e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '2048' at 5.156810e-04,5.771175e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 2.493248e-03,1.470621e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 6 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 7 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 8 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 10 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 11 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 12 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 14 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  7.350445e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
