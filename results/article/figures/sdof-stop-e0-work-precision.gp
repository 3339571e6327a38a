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
set ylabel 'error of x and force [-]'
set xrange [1.11e-05:2.16e-02]
set yrange [1.46e-12:2.55e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0424 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.871160e-04,4.385103e-12 to graph 1.05,0.0424 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1044 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 9.738900e-05,4.385103e-12 to graph 1.05,0.1044 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.2066 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 7.194056e-03,3.071593e-10 to graph 1.05,0.2066 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.6755 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 5.818110e-04,5.728284e-05 to graph 1.05,0.6755 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.7800 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.269271e-03,8.572450e-04 to graph 1.05,0.7800 nohead lc rgb '#009E73' lw 0.5 back
set label '10 error bars' at graph 0.99, first 4.385103e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.679080e-04,8.961821e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.812020e-04,3.409943e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 1.956510e-04,1.251224e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 2.216810e-04,4.507921e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 2.902590e-04,1.609607e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 5.818110e-04,5.728284e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.579800e-03,1.338841e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 4.001169e-03,1.912056e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 4.727669e-03,8.893042e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 7.194056e-03,3.071593e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.206980e-04,4.385103e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-8' at 1.871160e-04,4.385103e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 4.257200e-05,4.385103e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '128' at 3.319800e-05,8.496359e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 1.676730e-04,2.292662e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 8.433770e-04,2.493432e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 4.269271e-03,8.572450e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  4.385103e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
