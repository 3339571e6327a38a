# gnuplot sdof-stop-near-work-precision.gp makes sdof-stop-near-work-precision.svg and sdof-stop-near-work-precision.pdf of sdof-stop-near-work-precision.dat
data = 'sdof-stop-near-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-near-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.50e-05:2.93e-02]
set yrange [3.76e-13:2.03e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.589
set label 'event-driven[flow=modal]' at graph 1.06,0.0407 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.147780e-04,1.127771e-12 to graph 1.05,0.0407 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1027 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 9.498600e-05,1.127771e-12 to graph 1.05,0.1027 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1871 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 9.762538e-03,5.887689e-11 to graph 1.05,0.1871 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6900 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.396890e-04,4.154387e-04 to graph 1.05,0.6900 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.7520 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.299709e-03,4.162334e-04 to graph 1.05,0.7520 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.8140 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.153550e-04,4.162334e-04 to graph 1.05,0.8140 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8760 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.120440e-04,4.162334e-04 to graph 1.05,0.8760 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.9380 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.285881e-03,1.941525e-03 to graph 1.05,0.9380 nohead lc rgb '#000000' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 8.281145e-03,4.782827e-02 to graph 1.05,1.0000 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.127771e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.566510e-04,6.753077e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.609520e-04,2.517532e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.779040e-04,9.166612e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 2.046460e-04,3.293174e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.640620e-04,1.173744e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.153550e-04,4.162334e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '5' at 2.585160e-04,6.753077e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 4.721700e-04,2.517532e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.101905e-03,9.166612e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 3.540262e-03,3.293174e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 7.002538e-03,1.173744e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.299709e-03,4.162334e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 8.281145e-03,4.782827e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '1e-4' at 2.372032e-03,6.246003e-06 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 3.384313e-03,1.620222e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 6.646864e-03,7.800637e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 9.762538e-03,5.887689e-11 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.099340e-04,1.127771e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 4.492700e-05,1.127771e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '2048' at 6.258210e-04,7.759946e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 3.285881e-03,1.941525e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 5 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 13 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 15 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  1.127771e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
