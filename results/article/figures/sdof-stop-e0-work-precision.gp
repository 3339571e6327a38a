# gnuplot sdof-stop-e0-work-precision.gp makes sdof-stop-e0-work-precision.svg and sdof-stop-e0-work-precision.pdf of sdof-stop-e0-work-precision.dat
data = 'sdof-stop-e0-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e0-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [9.90e-06:1.92e-02]
set yrange [1.46e-12:1.80e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0430 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.070190e-04,4.385103e-12 to graph 1.05,0.0430 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1050 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 9.975200e-05,4.385103e-12 to graph 1.05,0.1050 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1746 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 6.391076e-03,1.262277e-10 to graph 1.05,0.1746 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6845 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.583190e-04,5.718304e-05 to graph 1.05,0.6845 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.7465 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.322000e-04,5.728284e-05 to graph 1.05,0.7465 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8085 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.325090e-04,5.728284e-05 to graph 1.05,0.8085 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8705 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.166339e-03,6.086668e-04 to graph 1.05,0.8705 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 4.385103e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.572420e-04,8.961821e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.644830e-04,3.409943e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.794620e-04,1.251224e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 2.061890e-04,4.507921e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.711590e-04,1.609607e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.322000e-04,5.728284e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.483085e-03,5.959553e-06 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 2.424570e-03,1.912056e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 4.355615e-03,3.975890e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 6.391076e-03,1.262277e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.005190e-04,4.385103e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 4.698600e-05,4.385103e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '128' at 2.970900e-05,6.009870e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 1.476410e-04,1.626185e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 5.977960e-04,1.770635e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 3.166339e-03,6.086668e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  4.385103e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
