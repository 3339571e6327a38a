# gnuplot chain10-stop-work-precision.gp makes chain10-stop-work-precision.svg and chain10-stop-work-precision.pdf of chain10-stop-work-precision.dat
data = 'chain10-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain10-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [8.86e-05:3.31e-01]
set yrange [3.47e-12:4.01e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0080 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.723793e-03,1.041120e-11 to graph 1.05,0.0080 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.0700 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 9.080190e-04,1.041120e-11 to graph 1.05,0.0700 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1320 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 8.280226e-02,2.327247e-11 to graph 1.05,0.1320 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.1940 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 3.324482e-03,2.209479e-04 to graph 1.05,0.1940 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.2560 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.467942e-02,2.162955e-03 to graph 1.05,0.2560 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.3180 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 6.822211e-02,9.667502e-03 to graph 1.05,0.3180 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.3800 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 2.778539e-02,9.667502e-03 to graph 1.05,0.3800 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.4420 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.102359e-01,1.275698e-02 to graph 1.05,0.4420 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.015499e-01,1.358554e-02 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.032428e-01,1.358554e-02 to graph 1.05,0.5660 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.6280 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.017194e-02,2.096400e-02 to graph 1.05,0.6280 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.646283e-02,2.602432e-02 to graph 1.05,0.6900 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.605071e-02,3.031265e-02 to graph 1.05,0.7520 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 5.433926e-02,3.112736e-02 to graph 1.05,0.8140 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.551998e-02,3.112736e-02 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 7.958410e-02,6.842419e-02 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=100x]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 6.695411e-02,7.946071e-02 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.041120e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '40' at 1.579602e-02,3.090791e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 3.151091e-02,1.635884e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.015499e-01,1.358554e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10, 1e5' at 3.704700e-04,7.979890e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40, 1e5' at 2.309792e-03,3.437194e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 5.433926e-02,3.112736e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '20' at 2.253095e-03,1.337553e-01 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.294512e-03,2.373447e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 7.778314e-03,1.141187e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 2.778539e-02,9.667502e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 2.217915e-02,2.373447e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160' at 6.822211e-02,9.667502e-03 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '10' at 1.428164e-03,1.299312e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 1.447540e-03,5.067281e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 1.569732e-03,1.742944e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 2.028760e-03,6.213566e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 3.324482e-03,2.209479e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.823234e-02,7.242532e-06 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 3.132416e-02,9.022302e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 5.255846e-02,3.261792e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 8.280226e-02,2.327247e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 1.583617e-03,1.041120e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 7.044130e-04,1.041120e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1' at 7.958410e-02,6.842419e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1e3' at 1.439696e-03,2.410687e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10, 1e5' at 2.695710e-04,7.979890e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 1.580961e-03,3.437194e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 3.551998e-02,3.112736e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '128' at 3.008990e-04,1.321306e-01 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 5.482598e-03,8.273211e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 2.467942e-02,2.162955e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '80' at 4.765092e-02,1.869210e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.996530e-03,2.274643e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 2.731249e-03,7.355942e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
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
  data index 13 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 17 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 19 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 21 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 22 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 23 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 24 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 25 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 26 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 27 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 28 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 29 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 30 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 31 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  data index 32 with lines lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 33 with points lc rgb '#000000' pt 9 ps 1.1 notitle, \
  1.041120e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
