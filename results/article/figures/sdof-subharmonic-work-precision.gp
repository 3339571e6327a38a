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
set ylabel 'error of x and force [-]'
set xrange [1.39e-05:5.06e-02]
set yrange [2.45e-11:1.73e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0484 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.076975e-04,7.350445e-11 to graph 1.05,0.0484 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1104 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.691400e-05,8.642159e-11 to graph 1.05,0.1104 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1724 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.685081e-02,7.712447e-10 to graph 1.05,0.1724 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.7029 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 4.445520e-04,2.053161e-04 to graph 1.05,0.7029 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8913 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.387969e-03,1.470621e-02 to graph 1.05,0.8913 nohead lc rgb '#009E73' lw 0.5 back
set label '10 error bars' at graph 0.99, first 8.642159e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.572980e-04,3.223647e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.700215e-04,1.225565e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 1.885680e-04,4.494370e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 2.187835e-04,1.618658e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 2.738280e-04,5.776960e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 4.445520e-04,2.053161e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 5.064967e-03,8.839281e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 5.910108e-03,8.871724e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.323071e-02,3.663797e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.685081e-02,7.712447e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.963160e-04,4.133363e-10 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 2.076975e-04,7.350445e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 4.173800e-05,7.350445e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 8.691400e-05,8.642159e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 5.162325e-04,5.771175e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 2.387969e-03,1.470621e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 6 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 7 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 8 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 10 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  8.642159e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
