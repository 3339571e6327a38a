# gnuplot bar10-massless-convergence.gp makes bar10-massless-convergence.svg and bar10-massless-convergence.pdf of bar10-massless-convergence.dat
data = 'bar10-massless-convergence.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'bar10-massless-convergence.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'harmonics, or samples of a period [-]'
set ylabel 'error of x and force [-]'
set xrange [1.67e+00:2.46e+04]
set yrange [1.19e-06:2.00e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'hat-lcp' at graph 1.06,0.0700 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 8.192000e+03,3.570017e-06 to graph 1.05,0.0700 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true]' at graph 1.06,0.1320 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.600000e+02,1.503986e-04 to graph 1.05,0.1320 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,continuation=frequency]' at graph 1.06,0.1940 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.503986e-04 to graph 1.05,0.1940 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm[plain=true]' at graph 1.06,0.2560 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.600000e+02,1.503986e-04 to graph 1.05,0.2560 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm[plain=true,continuation=frequency]' at graph 1.06,0.3180 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.600000e+02,1.503986e-04 to graph 1.05,0.3180 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.3800 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,1.585295e-04 to graph 1.05,0.3800 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.4420 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.600000e+02,1.585295e-04 to graph 1.05,0.4420 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5040 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.600000e+02,1.585295e-04 to graph 1.05,0.5040 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.5660 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,1.862522e-04 to graph 1.05,0.5660 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.600000e+02,1.862522e-04 to graph 1.05,0.6280 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.600000e+02,2.695276e-04 to graph 1.05,0.6900 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.600000e+02,2.874346e-04 to graph 1.05,0.7520 nohead lc rgb '#D55E00' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.600000e+02,3.543528e-04 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,continuation=frequency]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.600000e+02,1.612038e-03 to graph 1.05,0.8760 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.600000e+02,1.612038e-03 to graph 1.05,0.9380 nohead lc rgb '#009E73' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=100x]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.600000e+02,1.612038e-03 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set object polygon from 2.0000e+00,4.7600e-06 to 4.0000e+00,2.3800e-06 to 2.0000e+00,2.3800e-06 to 2.0000e+00,4.7600e-06 fillstyle empty border lc rgb '#666666'
set label '1' at 4.0000e+00,3.3658e-06 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set object polygon from 2.0000e+00,7.6160e-05 to 4.0000e+00,1.9040e-05 to 2.0000e+00,1.9040e-05 to 2.0000e+00,7.6160e-05 fillstyle empty border lc rgb '#666666'
set label '2' at 4.0000e+00,3.8080e-05 left offset -0.6,0.3 font ',8' textcolor rgb '#666666'
set label '5' at 5.000000e+00,6.655763e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.000000e+01,4.537544e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 2.000000e+01,6.159584e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 4.000000e+01,1.279388e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 8.000000e+01,4.451526e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.600000e+02,1.585295e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 1.000000e+01,1.379260e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '5' at 5.000000e+00,4.422234e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '128' at 1.280000e+02,1.071212e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '512' at 5.120000e+02,6.937859e-04 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.048000e+03,4.290382e-05 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 8.192000e+03,3.570017e-06 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 4.000000e+01,2.385689e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 8.000000e+01,9.211544e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.600000e+02,3.543528e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.600000e+02,1.612038e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40' at 4.000000e+01,3.453647e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '-' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 7 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#CC79A7' dt '_.' lw 1.6 notitle, \
  data index 5 with points lc rgb '#CC79A7' pt 11 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 9 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 11 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 13 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 19 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 21 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 22 with lines lc rgb '#56B4E9' dt '..-' lw 1.6 notitle, \
  data index 23 with points lc rgb '#56B4E9' pt 7 ps 1.1 notitle, \
  data index 24 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 25 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 26 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 27 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  data index 28 with lines lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 29 with points lc rgb '#000000' pt 9 ps 1.1 notitle, \
  data index 30 with lines lc rgb '#009E73' dt '_.' lw 1.6 notitle, \
  data index 31 with points lc rgb '#009E73' pt 15 ps 1.1 notitle
unset output
}
