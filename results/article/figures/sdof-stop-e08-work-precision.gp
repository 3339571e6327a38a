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
set ylabel 'error of x and force [-]'
set xrange [1.85e-05:5.20e-02]
set yrange [1.30e-12:1.06e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'event-driven[flow=modal]' at graph 1.06,0.0437 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.181780e-04,3.914646e-12 to graph 1.05,0.0437 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1057 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.112360e-04,3.914646e-12 to graph 1.05,0.1057 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.2412 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.733429e-02,5.589560e-10 to graph 1.05,0.2412 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.7145 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 5.660715e-04,8.147548e-05 to graph 1.05,0.7145 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8500 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.840607e-03,2.450348e-03 to graph 1.05,0.8500 nohead lc rgb '#009E73' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.914646e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 2.016900e-04,1.274851e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 2.139650e-04,4.850412e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.325600e-04,1.779537e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 2.642450e-04,6.410838e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 2.704530e-04,2.289053e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 5.660715e-04,8.147548e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 4.740764e-03,1.088775e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 5.688993e-03,1.111216e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.278181e-02,1.971041e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.733429e-02,5.589560e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 2.361775e-04,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-10' at 3.181780e-04,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 5.549950e-05,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 1.112360e-04,3.914646e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 1.082860e-04,3.537496e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 5.854570e-04,9.822029e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 2.840607e-03,2.450348e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
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
  3.914646e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
