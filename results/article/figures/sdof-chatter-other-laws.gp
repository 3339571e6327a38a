# gnuplot sdof-chatter-other-laws.gp makes sdof-chatter-other-laws.svg and sdof-chatter-other-laws.pdf of sdof-chatter-other-laws.dat
data = 'sdof-chatter-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-chatter-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force, own law [-]'
set xrange [3.93e-02:6.59e+00]
set yrange [1.30e-12:2.24e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'augmented-lagrangian (e = 1)' at graph 1.06,0.6280 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.512317e-01,5.566422e-02 to graph 1.05,0.6280 nohead lc rgb '#E69F00' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x] (e = 1)' at graph 1.06,0.6900 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.153374e-01,5.904368e-02 to graph 1.05,0.6900 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true,c=1e5] (e = 1)' at graph 1.06,0.7520 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 4.266075e-01,5.934055e-02 to graph 1.05,0.7520 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting,c=1e5] (e = 1)' at graph 1.06,0.8140 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 4.206268e-01,5.934055e-02 to graph 1.05,0.8140 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz (e = 1)' at graph 1.06,0.8760 left font ',9' textcolor rgb '#CC79A7' noenhanced
set arrow from 2.034154e+00,7.223554e-02 to graph 1.05,0.8760 nohead lc rgb '#CC79A7' lw 0.5 back
set label 'aft-hbm (e = 1)' at graph 1.06,0.9380 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.195780e+00,7.223554e-02 to graph 1.05,0.9380 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm (e = 1)' at graph 1.06,1.0000 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.180296e-01,7.451463e-02 to graph 1.05,1.0000 nohead lc rgb '#E69F00' lw 0.5 back
set label '10 error bars' at graph 0.99, first 3.900630e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '160' at 2.195780e+00,7.223554e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160, 1e5' at 4.266075e-01,5.934055e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '160' at 1.512317e-01,5.566422e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.180296e-01,7.451463e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 2.153374e-01,5.904368e-02 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#CC79A7' dt 1 lw 1.6 notitle, \
  data index 7 with points lc rgb '#CC79A7' pt 13 ps 1.1 notitle, \
  data index 8 with lines lc rgb '#0072B2' dt '..-' lw 1.6 notitle, \
  data index 9 with points lc rgb '#0072B2' pt 9 ps 1.1 notitle, \
  data index 10 with lines lc rgb '#E69F00' dt '_.' lw 1.6 notitle, \
  data index 11 with points lc rgb '#E69F00' pt 5 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  3.900630e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
