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
set ylabel 'error of x [-]'
set xrange [1.82e-04:9.01e-01]
set yrange [2.22e-12:4.77e-02]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.679
set label 'exact-orbit' at graph 1.06,0.0462 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.806352e-03,6.663184e-12 to graph 1.05,0.0462 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1607 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.026295e-03,1.015273e-10 to graph 1.05,0.1607 nohead lc rgb '#0072B2' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.2227 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.051758e-02,1.015311e-10 to graph 1.05,0.2227 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8372 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.002025e-01,9.918905e-04 to graph 1.05,0.8372 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 6.475339e-09 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '1e-4' at 3.574636e-03,6.000634e-06 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 4.868006e-03,1.113317e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 7.409568e-03,6.475339e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.051758e-02,1.015311e-10 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 5.457120e-04,1.574446e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 7.271210e-04,6.677679e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 8.747000e-04,6.475310e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.026295e-03,1.015273e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 6.089970e-04,2.561744e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 2.806352e-03,6.663184e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 6.054493e-03,1.591127e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 4.888466e-02,4.005317e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 3.002025e-01,9.918905e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 2 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  data index 3 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 4 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 5 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 9 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  6.475339e-09 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
