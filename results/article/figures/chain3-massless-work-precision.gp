# gnuplot chain3-massless-work-precision.gp makes chain3-massless-work-precision.svg and chain3-massless-work-precision.pdf of chain3-massless-work-precision.dat
data = 'chain3-massless-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-massless-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [4.08e-05:2.87e+01]
set yrange [1.15e-11:2.76e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'exact-orbit' at graph 1.06,-0.1780 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.169764e-03,3.453322e-11 to graph 1.05,-0.1780 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,-0.1160 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.085430e-04,4.384670e-07 to graph 1.05,-0.1160 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,-0.0540 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.950683e-02,4.385336e-07 to graph 1.05,-0.0540 nohead lc rgb '#0072B2' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.0080 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 5.578014e-02,1.266682e-05 to graph 1.05,0.0080 nohead lc rgb '#009E73' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.0700 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.847187e-01,2.372041e-04 to graph 1.05,0.0700 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,0.1320 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.491976e+00,2.372041e-04 to graph 1.05,0.1320 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.1940 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 2.424451e+00,2.372041e-04 to graph 1.05,0.1940 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.2560 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.309135e-03,2.522940e-04 to graph 1.05,0.2560 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.620936e-03,2.522940e-04 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.3800 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.490118e-03,2.522940e-04 to graph 1.05,0.3800 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.4420 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.192046e-01,3.273856e-04 to graph 1.05,0.4420 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.5040 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.268068e+00,3.831750e-04 to graph 1.05,0.5040 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.501664e+00,4.538062e-04 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 5.149483e-03,4.874716e-04 to graph 1.05,0.6280 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 9.576342e+00,5.111858e-04 to graph 1.05,0.6900 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 6.786186e+00,5.121172e-04 to graph 1.05,0.7520 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 5.511396e+00,5.121172e-04 to graph 1.05,0.8140 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.8760 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 5.621571e-03,1.290375e-03 to graph 1.05,0.8760 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,continuation=frequency]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 5.011583e-01,5.406875e-03 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=100x]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.893390e+00,6.545114e-03 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.453322e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '10' at 2.187930e-04,8.892529e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 6.315505e-04,7.758753e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.081377e-03,2.315190e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 1.501327e-03,7.702444e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 3.309135e-03,2.522940e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 5.576526e-03,2.876872e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 1.765133e-02,2.049411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 1.847187e-01,2.372041e-04 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40, 1e5' at 1.610369e-02,4.482083e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 5.511396e+00,5.121172e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 4.833550e-04,9.202605e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.808995e-03,1.584734e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 8.221413e-03,2.731554e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.060539e-02,9.007636e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.192046e-01,3.273856e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 1.395930e-04,8.892529e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 3.836670e-04,7.758753e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 6.845450e-04,2.315190e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 8.554107e-03,1.041987e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.414217e-02,6.169463e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.710975e-02,4.395485e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 2.950683e-02,4.385336e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 2.715440e-04,4.383076e-07 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-8' at 4.085430e-04,4.384670e-07 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 1.343640e-04,3.453322e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 1.169764e-03,3.453322e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 2.844580e-04,7.758753e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '160' at 2.490118e-03,2.522940e-04 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '40' at 6.481253e-02,2.049411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.491976e+00,2.372041e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10, 1' at 1.474381e-03,2.876872e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1' at 3.569853e-02,2.049411e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1' at 2.424451e+00,2.372041e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1e3' at 5.396416e-02,3.674306e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160, 1e3' at 2.268068e+00,3.831750e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 5.112788e-03,4.874716e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 5.796011e-03,1.049774e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 5.578014e-02,1.266682e-05 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 3.198805e-04,1.072303e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.098479e-03,8.388665e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.049590e-03,3.426578e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 5.621571e-03,1.290375e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.011583e-01,5.406875e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40' at 2.806800e-02,4.229324e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 9.576342e+00,5.111858e-04 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 1.893390e+00,6.545114e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 19 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 21 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 22 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 23 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 24 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 25 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 26 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 27 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 28 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 29 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  data index 30 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 31 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 32 with lines lc rgb '#56B4E9' dt '..-' lw 1.6 notitle, \
  data index 33 with points lc rgb '#56B4E9' pt 7 ps 1.1 notitle, \
  data index 34 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 35 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 36 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 37 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  data index 38 with lines lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 39 with points lc rgb '#000000' pt 9 ps 1.1 notitle, \
  3.453322e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
