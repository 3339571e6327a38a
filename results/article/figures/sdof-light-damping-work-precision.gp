# gnuplot sdof-light-damping-work-precision.gp makes sdof-light-damping-work-precision.svg and sdof-light-damping-work-precision.pdf of sdof-light-damping-work-precision.dat
data = 'sdof-light-damping-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-light-damping-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [2.07e-05:1.20e+01]
set yrange [6.50e-12:2.92e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0448 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.020252e-03,1.948987e-11 to graph 1.05,0.0448 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1068 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.230120e-04,1.948987e-11 to graph 1.05,0.1068 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1688 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 5.386722e-02,5.551215e-11 to graph 1.05,0.1688 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 5.873210e-04,2.725653e-04 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3800 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.787831e-02,2.722282e-03 to graph 1.05,0.3800 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.4420 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.318155e-02,1.705713e-02 to graph 1.05,0.4420 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5040 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.465590e-03,2.272242e-02 to graph 1.05,0.5040 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 3.552875e-03,2.272242e-02 to graph 1.05,0.5660 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.010354e-02,2.364903e-02 to graph 1.05,0.6280 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.488681e-01,2.669468e-02 to graph 1.05,0.6900 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.084185e-01,2.669468e-02 to graph 1.05,0.7520 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 7.757845e-02,3.315360e-02 to graph 1.05,0.8140 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.607983e-01,4.606180e-02 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 4.002029e+00,6.658683e-02 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 6.798232e-02,9.251163e-02 to graph 1.05,1.0000 nohead lc rgb '#0072B2' lw 0.5 back
set label '10 error bars' at graph 0.99, first 1.948987e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '40' at 1.683548e-03,9.311884e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.542332e-03,4.580926e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 3.465590e-03,2.272242e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 4.951103e-03,6.663543e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 1.488681e-01,2.669468e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 1.128826e-02,6.928545e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 4.507641e-03,3.428819e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.318155e-02,1.705713e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '5' at 3.067120e-04,4.288185e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 3.115600e-04,1.625642e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 3.322580e-04,5.955383e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 3.595910e-04,2.144328e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 4.249640e-04,7.655577e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 5.873210e-04,2.725653e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.591557e-02,4.423105e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 2.359027e-02,1.694384e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 3.412671e-02,8.800416e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 5.386722e-02,5.551215e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 9.159550e-04,8.713770e-10 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 9.208840e-04,1.948987e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 6.208800e-05,1.948987e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 2.230120e-04,1.948987e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1' at 4.002029e+00,6.658683e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1e3' at 1.607983e-01,4.606180e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160, 1e5' at 1.084185e-01,2.669468e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 5.652010e-04,4.435225e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 3.038853e-03,1.093089e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 1.787831e-02,2.722282e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '80' at 4.515000e-03,4.774347e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.010354e-02,2.364903e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 6.798232e-02,9.251163e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 3.574906e-03,6.899689e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 7.757845e-02,3.315360e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
  data index 12 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 14 with points lc rgb '#009E73' pt 10 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 16 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 17 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 18 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 19 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 20 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 22 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 24 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 26 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 27 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 28 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 29 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 30 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  1.948987e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
