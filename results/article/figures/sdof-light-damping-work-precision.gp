# gnuplot sdof-light-damping-work-precision.gp makes sdof-light-damping-work-precision.svg and sdof-light-damping-work-precision.pdf of sdof-light-damping-work-precision.dat
data = 'sdof-light-damping-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-light-damping-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [2.08e-05:1.51e-01]
set yrange [6.50e-12:1.33e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0463 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 7.990030e-04,1.948987e-11 to graph 1.05,0.0463 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1083 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.302470e-04,1.948987e-11 to graph 1.05,0.1083 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1703 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 5.041883e-02,5.551215e-11 to graph 1.05,0.1703 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.7392 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 5.721090e-04,2.720697e-04 to graph 1.05,0.7392 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.8012 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 5.538090e-04,2.725653e-04 to graph 1.05,0.8012 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8632 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 5.562510e-04,2.725653e-04 to graph 1.05,0.8632 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.9252 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.241722e-02,2.725653e-04 to graph 1.05,0.9252 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.9872 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.753884e-02,2.722282e-03 to graph 1.05,0.9872 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.948987e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 2.880120e-04,4.288185e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 2.990270e-04,1.625642e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 3.125860e-04,5.955383e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 3.380820e-04,2.144328e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 3.980970e-04,7.655577e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 5.538090e-04,2.725653e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 5.561500e-04,1.625642e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 2.052229e-03,5.955383e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.153057e-02,2.144328e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 4.558939e-03,7.655577e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.241722e-02,2.725653e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 1.410675e-02,4.423105e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 2.131879e-02,1.694384e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 3.155144e-02,8.800416e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 5.041883e-02,5.551215e-11 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 7.001350e-04,8.713770e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 7.408300e-04,1.948987e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 6.225400e-05,1.948987e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 2.302470e-04,1.948987e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 5.600380e-04,4.435225e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 3.156800e-03,1.093089e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 1.753884e-02,2.722282e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 8 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 10 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 11 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 12 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 14 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 16 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  1.948987e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
