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
set ylabel 'error of x [-]'
set xrange [5.41e-05:1.75e-01]
set yrange [2.76e-12:2.68e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0434 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.721900e-04,8.276851e-12 to graph 1.05,0.0434 nohead lc rgb '#0072B2' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1054 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.550710e-04,8.276851e-12 to graph 1.05,0.1054 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1674 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.583234e-02,8.498317e-11 to graph 1.05,0.1674 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.4420 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.887865e-03,7.497081e-05 to graph 1.05,0.4420 nohead lc rgb '#D55E00' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.5040 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.818553e-02,7.497082e-05 to graph 1.05,0.5040 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 2.881301e-03,1.111418e-04 to graph 1.05,0.5660 nohead lc rgb '#009E73' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.039538e-03,1.111418e-04 to graph 1.05,0.6280 nohead lc rgb '#0072B2' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.6900 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.712540e-02,6.196109e-03 to graph 1.05,0.6900 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 3.312012e-03,1.057116e-02 to graph 1.05,0.7520 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 1.138580e-02,1.057289e-02 to graph 1.05,0.8140 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 5.844448e-02,7.543210e-02 to graph 1.05,0.8760 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 5.716209e-02,7.543210e-02 to graph 1.05,0.9380 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp[plain=true]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 6.209000e-04,8.947115e-02 to graph 1.05,1.0000 nohead lc rgb '#0072B2' lw 0.5 back
set label '10 error bars' at graph 0.99, first 8.276851e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '20' at 6.203080e-04,5.441892e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.822088e-03,1.725593e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 2.293679e-03,3.230520e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 3.039538e-03,1.111418e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 5.844448e-02,7.543210e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '10' at 2.853150e-04,8.040905e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 8.803630e-04,3.242978e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 3.167557e-03,1.057289e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 4.411753e-03,2.064843e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.818553e-02,7.497082e-05 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.138580e-02,1.057289e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '1e-4' at 4.709995e-03,1.027873e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 8.154989e-03,1.092166e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 1.199235e-02,1.357492e-08 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.583234e-02,8.498317e-11 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 1.623650e-04,1.657639e-11 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.721900e-04,8.276851e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 3.967820e-04,8.276851e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '512' at 6.246550e-04,8.947115e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 2.712540e-02,6.196109e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 2.245110e-02,3.243277e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 3.447350e-04,3.242978e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 1.163190e-03,1.057289e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '80' at 1.420624e-03,2.064843e-03 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 1.887865e-03,7.497081e-05 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
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
  data index 12 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 13 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 14 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 15 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 16 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 17 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 18 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 19 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 20 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 21 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 22 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 23 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 24 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  data index 25 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 26 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  8.276851e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
