# gnuplot sdof-stop-work-precision.gp makes sdof-stop-work-precision.svg and sdof-stop-work-precision.pdf of sdof-stop-work-precision.dat
data = 'sdof-stop-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force [-]'
set xrange [1.28e-05:1.86e-01]
set yrange [9.41e-12:2.42e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'event-driven[flow=modal]' at graph 1.06,0.0458 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 4.980840e-04,2.823575e-11 to graph 1.05,0.0458 nohead lc rgb '#D55E00' lw 0.5 back
set label 'exact-orbit' at graph 1.06,0.1078 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 7.700050e-05,2.823575e-11 to graph 1.05,0.1078 nohead lc rgb '#009E73' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1698 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.141951e-02,4.724861e-10 to graph 1.05,0.1698 nohead lc rgb '#0072B2' lw 0.5 back
set label 'closed-hbm' at graph 1.06,0.3180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 4.411850e-04,8.265643e-05 to graph 1.05,0.3180 nohead lc rgb '#000000' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.3800 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.909404e-03,2.524157e-03 to graph 1.05,0.3800 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian[plain=true]' at graph 1.06,0.4420 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 5.258872e-02,1.548778e-02 to graph 1.05,0.4420 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.5040 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.282013e-03,1.548778e-02 to graph 1.05,0.5040 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.5660 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 5.257381e-03,2.051131e-02 to graph 1.05,0.5660 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 7.405148e-03,2.051131e-02 to graph 1.05,0.6280 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6900 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 3.196310e-02,2.131526e-02 to graph 1.05,0.6900 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5]' at graph 1.06,0.7520 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.193796e-02,2.376002e-02 to graph 1.05,0.7520 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5]' at graph 1.06,0.8140 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 8.456400e-04,2.376002e-02 to graph 1.05,0.8140 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x]' at graph 1.06,0.8760 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 7.919290e-04,3.637403e-02 to graph 1.05,0.8760 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.685395e-03,4.246816e-02 to graph 1.05,0.9380 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 6.214118e-02,5.825545e-02 to graph 1.05,1.0000 nohead lc rgb '#56B4E9' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.823575e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '40' at 2.115584e-03,7.758057e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 3.067917e-03,4.024793e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 7.405148e-03,2.051131e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 6.010880e-04,5.994521e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 1.193796e-02,2.376002e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 5.380574e-03,5.908970e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.984209e-03,3.048273e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.282013e-03,1.548778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.149924e-02,5.908970e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160' at 5.258872e-02,1.548778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '5' at 1.512650e-04,1.295183e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '10' at 1.576780e-04,4.927725e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '20' at 1.765650e-04,1.807859e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 2.090550e-04,6.512404e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '80' at 2.726250e-04,2.324693e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 4.411850e-04,8.265643e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 7.610646e-03,1.125188e-05 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 1.141075e-02,1.274954e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-8' at 1.923080e-02,1.458783e-08 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-10' at 3.141951e-02,4.724861e-10 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-4' at 4.421370e-04,2.823575e-11 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '64' at 3.834300e-05,2.823575e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '256' at 7.700050e-05,2.823575e-11 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160' at 5.257381e-03,2.051131e-02 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '160, 1' at 6.214118e-02,5.825545e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1e3' at 1.685395e-03,4.246816e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40, 1e5' at 1.074330e-04,5.994521e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 8.456400e-04,2.376002e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 1.055500e-04,3.856259e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '2048' at 3.960890e-04,1.010643e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '8192' at 1.909404e-03,2.524157e-03 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 5.227124e-03,8.053085e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.699465e-02,4.180953e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 3.196310e-02,2.131526e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.919290e-04,3.637403e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
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
  data index 28 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 29 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  2.823575e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
