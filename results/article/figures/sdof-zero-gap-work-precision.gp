# gnuplot sdof-zero-gap-work-precision.gp makes sdof-zero-gap-work-precision.svg and sdof-zero-gap-work-precision.pdf of sdof-zero-gap-work-precision.dat
data = 'sdof-zero-gap-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-zero-gap-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [1.93e-05:1.27e+00]
set yrange [2.17e-11:2.38e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0475 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.899470e-04,6.523509e-11 to graph 1.05,0.0475 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1095 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.226820e-04,6.523509e-11 to graph 1.05,0.1095 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1715 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.475514e-02,4.851671e-10 to graph 1.05,0.1715 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.3800 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 5.857580e-04,1.595785e-04 to graph 1.05,0.3800 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.4420 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.230375e-03,4.711483e-03 to graph 1.05,0.4420 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.5040 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 2.422775e-01,2.899336e-02 to graph 1.05,0.5040 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.5660 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.464545e-01,2.899336e-02 to graph 1.05,0.5660 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.232012e-01,3.640423e-02 to graph 1.05,0.6280 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.6900 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 3.519527e-01,3.640423e-02 to graph 1.05,0.6900 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.7520 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 3.597074e-01,3.937555e-02 to graph 1.05,0.7520 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.570338e-02,4.323789e-02 to graph 1.05,0.8140 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.838929e-03,4.323789e-02 to graph 1.05,0.8760 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.959004e-03,6.759108e-02 to graph 1.05,0.9380 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.012529e-02,7.938577e-02 to graph 1.05,1.0000 nohead lc rgb '#000000' lw 0.5 back
set label '10 error bars' at graph 0.99, first 6.523509e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '80' at 1.134445e-01,7.532547e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 4.232012e-01,3.640423e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 2.570338e-02,4.323789e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '80' at 1.833835e-02,5.708516e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.464545e-01,2.899336e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 2.422775e-01,2.899336e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '5' at 2.203970e-04,2.507923e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 2.337420e-04,9.538823e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 2.506550e-04,3.498412e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 2.826750e-04,1.259904e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 3.670340e-04,4.495284e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 5.857580e-04,1.595785e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 5.979528e-03,3.059372e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 8.503891e-03,4.601287e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.339524e-02,1.705080e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 2.475514e-02,4.851671e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 3.705310e-04,1.466526e-09 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 3.699760e-04,6.523509e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 5.780800e-05,6.523509e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 1.226820e-04,6.523509e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e3' at 1.012529e-02,7.938577e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160, 1e5' at 4.838929e-03,4.323789e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 1.640910e-04,7.238946e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 7.125500e-04,1.876767e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 3.230375e-03,4.711483e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '80' at 3.902493e-02,7.835123e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 3.959004e-03,6.759108e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
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
  data index 19 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 20 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 22 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#009E73' dt '-' lw 1.6 notitle, \
  data index 24 with points lc rgb '#009E73' pt 13 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 26 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 27 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 28 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  6.523509e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
