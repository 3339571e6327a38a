# gnuplot sdof-stop-e08-other-laws.gp makes sdof-stop-e08-other-laws.svg and sdof-stop-e08-other-laws.pdf of sdof-stop-e08-other-laws.dat
data = 'sdof-stop-e08-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-stop-e08-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force, own law [-]'
set xrange [3.52e-05:2.55e-01]
set yrange [9.44e-12:3.57e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian[plain=true] (e = 1)' at graph 1.06,0.3800 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 8.498197e-02,1.548778e-02 to graph 1.05,0.3800 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'augmented-lagrangian (e = 1)' at graph 1.06,0.4420 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 7.565491e-03,1.548778e-02 to graph 1.05,0.4420 nohead lc rgb '#E69F00' lw 0.5 back
set label 'fourier-lipschitz (e = 1)' at graph 1.06,0.5040 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 5.427373e-03,2.051131e-02 to graph 1.05,0.5040 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm (e = 1)' at graph 1.06,0.5660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 6.236710e-03,2.051131e-02 to graph 1.05,0.5660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm (e = 1)' at graph 1.06,0.6280 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 6.999961e-02,2.131526e-02 to graph 1.05,0.6280 nohead lc rgb '#E69F00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5] (e = 1)' at graph 1.06,0.6900 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.575411e-02,2.376002e-02 to graph 1.05,0.6900 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5] (e = 1)' at graph 1.06,0.7520 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.199090e-03,2.376002e-02 to graph 1.05,0.7520 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x] (e = 1)' at graph 1.06,0.8140 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.093341e-03,3.637403e-02 to graph 1.05,0.8140 nohead lc rgb '#D55E00' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e3] (e = 1)' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 2.171530e-03,4.246816e-02 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1] (e = 1)' at graph 1.06,0.9380 left font ',9' textcolor rgb '#56B4E9' noenhanced
set arrow from 7.589698e-02,5.825545e-02 to graph 1.05,0.9380 nohead lc rgb '#56B4E9' lw 0.5 back
set label 'hat-lcp[plain=true] (undetermined)' at graph 1.06,1.0000 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 1.055040e-04,1.191590e-01 to graph 1.05,1.0000 nohead lc rgb '#CC79A7' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.832512e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '40' at 2.640007e-03,7.758057e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 3.404375e-03,4.024793e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 6.236710e-03,2.051131e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40, 1e5' at 8.402465e-04,5.994521e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160, 1e5' at 1.575411e-02,2.376002e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '40' at 6.973930e-03,5.908970e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 3.348913e-03,3.048273e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 7.565491e-03,1.548778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 1.392560e-02,5.908970e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160' at 8.498197e-02,1.548778e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1' at 7.589698e-02,5.825545e-02 offset 0.4,0.5 font ',7' textcolor rgb '#56B4E9' noenhanced
set label '160, 1e3' at 2.171530e-03,4.246816e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40, 1e5' at 1.393285e-04,5.994521e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 1.199090e-03,2.376002e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '512' at 1.055040e-04,1.191590e-01 offset 0.4,0.5 font ',7' textcolor rgb '#CC79A7' noenhanced
set label '40' at 6.604637e-03,8.053085e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 1.986839e-02,4.180953e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 6.999961e-02,2.131526e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.093341e-03,3.637403e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#56B4E9' dt 1 lw 1.6 notitle, \
  data index 7 with points lc rgb '#56B4E9' pt 15 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 9 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#56B4E9' dt '.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#56B4E9' pt 5 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#CC79A7' dt '.' lw 1.6 notitle, \
  data index 17 with points lc rgb '#CC79A7' pt 15 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 19 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 21 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  2.832512e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
