# gnuplot sdof-stop-work-precision.gp makes sdof-stop-work-precision.svg and sdof-stop-work-precision.pdf of sdof-stop-work-precision.dat
data = 'sdof-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.39e-05:9.04e-02]
set yrange [9.41e-12:1.77e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.589
set label 'event-driven[flow=modal]' at graph 1.06,0.0464 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.167610e-04,2.823575e-11 to graph 1.05,0.0464 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1084 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 7.959700e-05,2.823575e-11 to graph 1.05,0.1084 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1704 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.012144e-02,4.234721e-10 to graph 1.05,0.1704 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6757 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.427820e-04,8.251207e-05 to graph 1.05,0.6757 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.7377 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.645267e-03,8.265643e-05 to graph 1.05,0.7377 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.7997 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.153550e-04,8.265643e-05 to graph 1.05,0.7997 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8617 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.145890e-04,8.265643e-05 to graph 1.05,0.8617 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.9237 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.677248e-03,2.524157e-03 to graph 1.05,0.9237 nohead lc rgb '#000000' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.9857 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.212248e-02,5.908970e-02 to graph 1.05,0.9857 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.823575e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.362670e-04,1.295183e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.433330e-04,4.927725e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.601310e-04,1.807859e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.926290e-04,6.512404e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.526250e-04,2.324693e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.153550e-04,8.265643e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '5' at 2.850000e-04,1.295183e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 4.697280e-04,4.927725e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.202804e-03,1.807859e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.964501e-03,6.512404e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.901901e-03,2.324693e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.645267e-03,8.265643e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.212248e-02,5.908970e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '1e-4' at 6.889013e-03,1.125188e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 1.066602e-02,1.274954e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 1.852779e-02,1.317649e-08 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 3.012144e-02,4.234721e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 3.683910e-04,2.823575e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 4.155200e-05,2.823575e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 7.959700e-05,2.823575e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 8.723700e-05,3.856259e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 1.677248e-03,2.524157e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
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
  2.823575e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
