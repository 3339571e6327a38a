# gnuplot sdof-stop-e08-work-precision.gp makes sdof-stop-e08-work-precision.svg and sdof-stop-e08-work-precision.pdf of sdof-stop-e08-work-precision.dat
data = 'sdof-stop-e08-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e08-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [1.44e-05:3.79e-02]
set yrange [1.30e-12:1.06e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0437 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.846040e-04,3.914646e-12 to graph 1.05,0.0437 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1057 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 8.231300e-05,3.914646e-12 to graph 1.05,0.1057 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.2361 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.262153e-02,4.919532e-10 to graph 1.05,0.2361 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.7144 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.400810e-04,8.133188e-05 to graph 1.05,0.7144 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.7764 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.169080e-04,8.147548e-05 to graph 1.05,0.7764 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.8384 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.144930e-04,8.147548e-05 to graph 1.05,0.8384 nohead lc rgb '#009E73' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.9004 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.923645e-03,2.450348e-03 to graph 1.05,0.9004 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.914646e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 1.391620e-04,1.274851e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.503500e-04,4.850412e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 1.632340e-04,1.779537e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.954780e-04,6.410838e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.551930e-04,2.289053e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.169080e-04,8.147548e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 3.009097e-03,1.088775e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 4.468367e-03,1.111216e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 7.838671e-03,1.742009e-08 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.262153e-02,4.919532e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.636140e-04,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 4.329300e-05,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 8.231300e-05,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 9.953500e-05,3.537496e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 4.164950e-04,9.822029e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 1.923645e-03,2.450348e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
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
  3.914646e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
