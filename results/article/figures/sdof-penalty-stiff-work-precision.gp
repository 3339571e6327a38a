# gnuplot sdof-penalty-stiff-work-precision.gp makes sdof-penalty-stiff-work-precision.svg and sdof-penalty-stiff-work-precision.pdf of sdof-penalty-stiff-work-precision.dat
data = 'sdof-penalty-stiff-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-penalty-stiff-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [6.54e-05:4.70e+00]
set yrange [2.76e-12:4.17e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0392 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.089960e-04,8.276851e-12 to graph 1.05,0.0392 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1012 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.427780e-04,8.276851e-12 to graph 1.05,0.1012 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1940 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.602343e-02,2.932042e-09 to graph 1.05,0.1940 nohead lc rgb '#0072B2' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.2560 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.482137e-02,1.126952e-02 to graph 1.05,0.2560 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.3180 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 4.479166e-02,1.587779e-02 to graph 1.05,0.3180 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.3800 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.806037e-03,1.587779e-02 to graph 1.05,0.3800 nohead lc rgb '#E69F00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.4420 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.858479e-02,1.587779e-02 to graph 1.05,0.4420 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.776666e-02,2.404111e-02 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.317009e-03,2.446511e-02 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.825859e-03,2.446511e-02 to graph 1.05,0.6280 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.6900 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 3.014065e-03,2.446511e-02 to graph 1.05,0.6900 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 5.093436e-02,1.727073e-01 to graph 1.05,0.7520 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.398334e-02,1.727073e-01 to graph 1.05,0.8140 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 6.330949e-02,1.753939e-01 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.567398e+00,4.006076e-01 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 6.403930e-04,1.391388e+00 to graph 1.05,1.0000 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 8.276851e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '20' at 6.387480e-04,7.593215e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.770270e-03,5.364694e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.243977e-03,2.415066e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 3.317009e-03,2.446511e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10, 1e5' at 3.366780e-04,1.148334e+00 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40, 1e5' at 3.189787e-03,6.602077e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 5.093436e-02,1.727073e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '10' at 2.963000e-04,6.231317e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 8.125060e-04,4.852533e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 2.857850e-03,3.277021e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 4.356906e-03,1.523418e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.858479e-02,1.587779e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.013347e-02,3.277021e-01 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160' at 4.479166e-02,1.587779e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '20' at 4.738770e-04,7.593215e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 4.736016e-03,7.916273e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 7.777041e-03,9.561076e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.213584e-02,5.427137e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 1.602343e-02,2.932042e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.962510e-04,9.438481e-10 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 2.089960e-04,8.276851e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 3.840560e-04,8.276851e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40, 1' at 5.707400e-02,8.460276e-01 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1' at 1.567398e+00,4.006076e-01 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1e3' at 5.917940e-03,6.777424e-01 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10, 1e5' at 2.518360e-04,1.148334e+00 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 2.365288e-03,6.602077e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 3.398334e-02,1.727073e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 6.328890e-04,1.391388e+00 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 1.784500e-02,1.107359e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 2.482137e-02,1.126952e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 1.117901e-03,3.277021e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.325564e-03,1.523418e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.806037e-03,1.587779e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 4.776666e-02,2.404111e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
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
  data index 27 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 28 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  data index 29 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 30 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 31 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 32 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  8.276851e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
