# gnuplot sdof-chatter-work-precision.gp makes sdof-chatter-work-precision.svg and sdof-chatter-work-precision.pdf of sdof-chatter-work-precision.dat
data = 'sdof-chatter-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-chatter-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [1.75e-04:8.96e-01]
set yrange [1.98e-12:4.77e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'exact-orbit' at graph 1.06,0.0460 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.960724e-03,5.947143e-12 to graph 1.05,0.0460 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.5801 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.053944e-03,2.086212e-06 to graph 1.05,0.5801 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.6421 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.094733e-02,2.086270e-06 to graph 1.05,0.6421 nohead lc rgb '#0072B2' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8379 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.986475e-01,9.918905e-04 to graph 1.05,0.8379 nohead lc rgb '#009E73' lw 0.5 back
set label '10 error bars' at graph 0.99, first 5.742160e-09 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '1e-4' at 3.556622e-03,3.876107e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 5.292748e-03,4.799909e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 7.617655e-03,7.165589e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.094733e-02,2.086270e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 5.677640e-04,3.474454e-05 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 7.201430e-04,4.774926e-05 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-8' at 8.868735e-04,7.159484e-06 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-10' at 1.053944e-03,2.086212e-06 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 5.252850e-04,2.275368e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 2.960724e-03,5.947143e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 6.143449e-03,1.591127e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 5.025583e-02,4.005317e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 2.986475e-01,9.918905e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  5.742160e-09 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
