# gnuplot sdof-two-sided-work-precision.gp makes sdof-two-sided-work-precision.svg and sdof-two-sided-work-precision.pdf of sdof-two-sided-work-precision.dat
data = 'sdof-two-sided-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-two-sided-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [6.00e-05:2.59e+00]
set yrange [9.77e-13:2.77e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'exact-orbit' at graph 1.06,0.0417 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.082640e-03,2.930860e-12 to graph 1.05,0.0417 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1037 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.013739e-02,3.634198e-12 to graph 1.05,0.1037 nohead lc rgb '#0072B2' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1940 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 6.551905e-04,3.638097e-07 to graph 1.05,0.1940 nohead lc rgb '#D55E00' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.2560 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.195100e-03,3.382368e-04 to graph 1.05,0.2560 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3180 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.039676e-01,9.775305e-04 to graph 1.05,0.3180 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.3800 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.139195e-02,7.297259e-03 to graph 1.05,0.3800 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.4420 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.509110e-02,7.297259e-03 to graph 1.05,0.4420 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.5040 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.914099e-02,7.597499e-03 to graph 1.05,0.5040 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.5660 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.777702e-01,1.220859e-02 to graph 1.05,0.5660 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.597573e-01,1.331793e-02 to graph 1.05,0.6280 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.865298e-01,1.331793e-02 to graph 1.05,0.6900 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 7.941052e-01,1.475935e-02 to graph 1.05,0.7520 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.713373e-01,1.532189e-02 to graph 1.05,0.8140 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 6.218392e-01,2.899491e-02 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 8.632699e-01,7.429872e-02 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 8.558211e-03,9.222127e-02 to graph 1.05,1.0000 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 4.252730e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '20' at 2.915169e-03,5.896714e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 4.519821e-03,2.931670e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 6.192352e-03,1.461591e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.509110e-02,7.297259e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 2.425611e-02,4.760542e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 4.597573e-01,1.331793e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '10' at 1.978008e-03,9.222127e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 8.054941e-03,4.502380e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 6.619689e-03,2.223054e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.593296e-02,1.104388e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.777702e-01,1.220859e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 8.558211e-03,9.222127e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '5' at 1.403266e-03,4.576414e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.375334e-03,2.146072e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 1.499153e-03,7.622385e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 1.593522e-03,2.697958e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 1.699677e-03,9.545538e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 2.195100e-03,3.382368e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 6.167499e-03,3.791636e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 9.520332e-03,2.112335e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.773268e-02,4.533671e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 2.013739e-02,3.634198e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 6.551905e-04,3.638097e-07 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 6.234350e-04,3.822861e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 1.799515e-04,3.100765e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 1.082640e-03,2.930860e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160' at 1.139195e-02,7.297259e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '40, 1' at 8.632699e-01,7.429872e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1e3' at 5.736448e-02,5.519577e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160, 1e3' at 7.941052e-01,1.475935e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '128' at 3.114900e-04,5.644617e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 2.494221e-03,1.583138e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 1.496956e-02,3.632747e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 1.039676e-01,9.775305e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 1.329942e-03,6.216147e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 6.369376e-03,3.068297e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.502070e-02,1.524359e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 6.218392e-01,2.899491e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 14 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 16 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 17 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 18 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 19 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 20 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 22 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 24 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 26 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 27 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 28 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 29 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 30 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 31 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 32 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  4.252730e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
