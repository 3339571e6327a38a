# gnuplot sdof-penalty-stiff-other-laws.gp makes sdof-penalty-stiff-other-laws.svg and sdof-penalty-stiff-other-laws.pdf of sdof-penalty-stiff-other-laws.dat
data = 'sdof-penalty-stiff-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-penalty-stiff-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force, own law [-]'
set xrange [8.27e-05:4.62e+00]
set yrange [2.61e-11:3.48e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=100x] (k = 100 N/m)' at graph 1.06,0.5180 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.540960e+00,1.511956e-05 to graph 1.05,0.5180 nohead lc rgb '#000000' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x] (k = 100000 N/m)' at graph 1.06,0.9316 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 2.703478e-02,6.031456e-01 to graph 1.05,0.9316 nohead lc rgb '#D55E00' lw 0.5 back
set label '10 error bars' at graph 0.99, first 7.826502e-11 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '10' at 2.479600e-04,1.160876e+00 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 2.130312e-03,9.384943e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 2.703478e-02,6.031456e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '10' at 1.147313e-03,8.785813e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '40' at 3.115666e-02,6.592325e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '160' at 1.540960e+00,1.511956e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 1 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#000000' dt 1 lw 1.6 notitle, \
  data index 3 with points lc rgb '#000000' pt 9 ps 1.1 notitle, \
  7.826502e-11 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
