# gnuplot bar10-massless-work-precision.gp makes bar10-massless-work-precision.svg and bar10-massless-work-precision.pdf of bar10-massless-work-precision.dat
data = 'bar10-massless-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'bar10-massless-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [1.69e-05:6.22e+00]
set yrange [3.10e-12:2.00e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'exact-orbit' at graph 1.06,-0.4260 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.289124e-03,9.286077e-12 to graph 1.05,-0.4260 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,-0.3640 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.171793e-01,5.120312e-07 to graph 1.05,-0.3640 nohead lc rgb '#0072B2' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,-0.3020 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.444956e-03,5.120326e-07 to graph 1.05,-0.3020 nohead lc rgb '#D55E00' lw 0.5 back
set label 'hat-lcp' at graph 1.06,-0.2400 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.704882e-02,3.570017e-06 to graph 1.05,-0.2400 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,-0.1780 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 4.482310e-01,1.503986e-04 to graph 1.05,-0.1780 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,-0.1160 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 6.334336e-01,1.503986e-04 to graph 1.05,-0.1160 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'aft-hbm[plain=true]' at graph 1.06,-0.0540 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.544918e-03,1.503986e-04 to graph 1.05,-0.0540 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.0080 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 7.324007e-02,1.503986e-04 to graph 1.05,0.0080 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.0700 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.889084e-03,1.585295e-04 to graph 1.05,0.0700 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.1320 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.226211e-02,1.585295e-04 to graph 1.05,0.1320 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.1940 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 4.999283e-03,1.585295e-04 to graph 1.05,0.1940 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.2560 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 4.588729e-02,1.862522e-04 to graph 1.05,0.2560 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.3180 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 4.827624e-02,1.862522e-04 to graph 1.05,0.3180 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.3800 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 7.948748e-01,2.601429e-04 to graph 1.05,0.3800 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.4420 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.326069e+00,2.695276e-04 to graph 1.05,0.4420 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.5040 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.072302e+00,2.874346e-04 to graph 1.05,0.5040 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.717253e+00,2.874666e-04 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.700528e+00,2.874666e-04 to graph 1.05,0.6280 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6900 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.389540e-02,3.543528e-04 to graph 1.05,0.6900 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.362251e-03,6.937859e-04 to graph 1.05,0.7520 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'fourier-lipschitz[plain=true]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 7.232750e-03,1.202827e-03 to graph 1.05,0.8140 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm[plain=true,continuation=frequency]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.470841e+00,1.612038e-03 to graph 1.05,0.8760 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.021992e-02,1.612038e-03 to graph 1.05,0.9380 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=100x]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 5.860808e-01,1.612038e-03 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 9.286077e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 6.775800e-05,6.655763e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.233630e-04,4.537544e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 3.714435e-04,6.159584e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 7.401215e-04,1.279388e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 1.674210e-03,4.451526e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.889084e-03,1.585295e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 4.186064e-03,1.379260e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 1.650863e-02,1.202827e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 7.324007e-02,1.503986e-04 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10, 1e5' at 2.719545e-04,4.740726e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40, 1e5' at 6.074708e-03,4.058365e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 1.700528e+00,2.874666e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '10' at 1.198670e-04,1.379260e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '40' at 4.552465e-04,1.202827e-03 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '160' at 2.544918e-03,1.503986e-04 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '10' at 4.962500e-04,5.101428e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 1.405460e-03,6.497121e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 4.052691e-03,1.405285e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.235033e-02,5.199143e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 4.588729e-02,1.862522e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 7.584450e-04,5.101428e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40' at 5.914780e-03,1.405285e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '20' at 2.345040e-04,6.159584e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 1.226211e-02,1.585295e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 2.373433e-02,6.724645e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 4.283336e-02,5.023220e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 7.610338e-02,5.117988e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.171793e-01,5.120312e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 3.325214e-03,5.120161e-07 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 2.289124e-03,9.286077e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 5.070600e-05,6.655763e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '10' at 8.890037e-03,1.379260e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.602227e-01,1.202827e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 4.482310e-01,1.503986e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10, 1' at 3.765950e-04,1.379260e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1' at 6.334336e-01,1.503986e-04 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '10, 1e3' at 1.861520e-04,4.913244e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40, 1e3' at 1.493664e-02,2.331206e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160, 1e3' at 7.948748e-01,2.601429e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 3.684203e-03,1.503986e-04 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 2.384764e-03,6.937859e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 1.130589e-02,4.290382e-05 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 3.704882e-02,3.570017e-06 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '5' at 5.662700e-05,4.812814e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 8.198620e-04,2.385689e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.297999e-03,9.211544e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.389540e-02,3.543528e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '10' at 1.509771e-02,4.802691e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40' at 2.972509e-01,1.930541e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160' at 1.470841e+00,1.612038e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40' at 1.155704e-02,3.453647e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.115823e-02,1.930541e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 5.860808e-01,1.612038e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 3.021992e-02,1.612038e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 7 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 11 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 13 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 15 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 17 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 19 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 21 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 22 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 23 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 24 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 25 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 26 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 27 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 28 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 29 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 30 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 31 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  data index 32 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 33 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 34 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 35 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  data index 36 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 37 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 38 with lines lc rgb '#56B4E9' dt '..-' lw 1.6 notitle, \
  data index 39 with points lc rgb '#56B4E9' pt 7 ps 1.1 notitle, \
  data index 40 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 41 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 42 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 43 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  data index 44 with lines lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 45 with points lc rgb '#000000' pt 9 ps 1.1 notitle, \
  data index 46 with lines lc rgb '#009E73' dt '_.' lw 1.6 notitle, \
  data index 47 with points lc rgb '#009E73' pt 15 ps 1.1 notitle, \
  9.286077e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
