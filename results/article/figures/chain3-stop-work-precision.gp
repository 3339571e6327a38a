# gnuplot chain3-stop-work-precision.gp makes chain3-stop-work-precision.svg and chain3-stop-work-precision.pdf of chain3-stop-work-precision.dat
data = 'chain3-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain3-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [3.77e-05:1.79e+00]
set yrange [1.84e-12:2.35e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=cvode]' at graph 1.06,0.0430 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.532098e-02,5.526554e-12 to graph 1.05,0.0430 nohead lc rgb '#0072B2' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1050 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 3.519670e-04,5.526554e-12 to graph 1.05,0.1050 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1670 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.128730e-04,5.526554e-12 to graph 1.05,0.1670 nohead lc rgb '#009E73' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.214599e-03,3.835223e-04 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3800 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.563759e-02,2.118438e-03 to graph 1.05,0.3800 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.4420 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 6.110207e-02,1.324605e-02 to graph 1.05,0.4420 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5040 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.345793e-02,1.765400e-02 to graph 1.05,0.5040 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.564924e-02,1.765400e-02 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 2.442655e-02,1.839107e-02 to graph 1.05,0.6280 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.6900 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.670184e-02,2.142304e-02 to graph 1.05,0.6900 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.032358e-02,2.326677e-02 to graph 1.05,0.7520 nohead lc rgb '#0072B2' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 3.885674e-02,2.326677e-02 to graph 1.05,0.8140 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 4.645540e-02,2.996361e-02 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.799069e-02,3.263209e-02 to graph 1.05,0.9380 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 5.962701e-01,4.890742e-02 to graph 1.05,1.0000 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 5.526554e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '40' at 3.947672e-03,7.207042e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 7.124987e-03,3.554376e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 2.564924e-02,1.765400e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 2.620770e-03,6.879168e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 3.885674e-02,2.326677e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 3.823561e-02,5.364360e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 6.110207e-02,1.324605e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '5' at 5.292530e-04,6.290424e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 6.061225e-04,2.321292e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 5.357130e-04,8.443515e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 6.190110e-04,3.033815e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 6.777430e-04,1.081523e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 1.214599e-03,3.835223e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 7.557430e-03,3.554580e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.264310e-02,4.101073e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.980900e-02,4.216873e-09 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 2.532098e-02,5.526554e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 3.196450e-04,8.047426e-09 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '1e-6' at 3.491405e-04,5.526554e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 1.131135e-04,5.526554e-12 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1' at 5.962701e-01,4.890742e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '40, 1e5' at 1.715869e-03,6.879168e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 7.335085e-04,3.442923e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 2.563838e-03,8.597140e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 1.563759e-02,2.118438e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '80' at 1.696255e-02,3.706744e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 2.799069e-02,3.263209e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.670184e-02,2.142304e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
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
  data index 10 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 11 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 12 with points lc rgb '#D55E00' pt 9 ps 1.1 notitle, \
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
  5.526554e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
